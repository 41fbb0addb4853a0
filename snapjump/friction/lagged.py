"""Lagged friction: the paper's, with normal force and velocity of the step's beginning.

It is explicit, hence unstable for steps above eps_v m / (mu N).
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import Need, number
from snapjump.friction.base import FrictionLaw, FrictionOptions, regularised_sign
from snapjump.units import Scales


class LaggedFriction(FrictionOptions):
    """Smoothed Coulomb friction of the last step's normal force and velocity (the paper)."""

    needs = (
        Need("contact", "force_is_of_position", "which uses the force of the position a step ago"),
    )

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

        def is_lagged(self) -> bool:
            return True

        def holds(self) -> Any:
            return self.mu > 0.0

        def ratio(self, velocity: Any) -> Any:
            sign, _ = regularised_sign(velocity, self.velocity_threshold)
            return self.mu * sign

        def slope(self, velocity: Any, previous: Any) -> Any:
            return 0.0 * velocity

    def law(self, scales: Scales, mu: float) -> Law:
        """The dimensionless law."""
        return self.Law(mu, self.velocity_threshold_m_s / scales.velocity_m_s)
