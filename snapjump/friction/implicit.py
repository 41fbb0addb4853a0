"""Implicit friction: normal force and velocity are the unknown ones of the stage."""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.friction.base import FrictionLaw, FrictionOptions, regularised_sign
from snapjump.number.functions import where
from snapjump.units import Scales


class ImplicitFriction(FrictionOptions):
    """Smoothed Coulomb friction of the unknown normal force and velocity."""

    velocity_threshold_m_s: float = number(
        1.0e-4,
        above=0.0,
        unit="m/s",
        doc="half width of the stick zone",
        symbol="ε_v",
        plan=(1e-4, 1e-2),
    )

    @FrictionLaw.member
    class Law(NamedTuple):
        """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

        mu: float
        velocity_threshold: float

        def holds(self) -> Any:
            return self.mu > 0.0

        def ratio(self, velocity: Any) -> Any:
            sign, _ = regularised_sign(velocity, self.velocity_threshold)
            return self.mu * sign

        def slope(self, velocity: Any, previous: Any) -> Any:
            _, slope = regularised_sign(velocity, self.velocity_threshold)
            # Newton would jump to and fro across the stick zone: after a change of sign, use the
            # slope at rest, the steepest there is.
            slope = where(velocity * previous < 0.0, 2.0 / self.velocity_threshold, slope)
            return self.mu * slope

    def law(self, scales: Scales, mu: float) -> Law:
        """The dimensionless law."""
        return self.Law(mu, self.velocity_threshold_m_s / scales.velocity_m_s)
