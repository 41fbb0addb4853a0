"""Smoothed Coulomb friction: what implicit and lagged friction have in common."""

from typing import Any, ClassVar

from snapjump.declare.fields import number
from snapjump.friction.base import FrictionLaw, FrictionOptions, regularised_sign
from snapjump.number.functions import maximum, where
from snapjump.units import Scales

MODERATE = 0.3  # coefficient of friction above which steps resolve a smaller stick zone
FINEST = 1e-6  # half width (L/T) of the finest zone that steps resolve, at twenty times the cost


class SmoothedCoulomb(FrictionLaw):
    """Coefficient mu, and velocity threshold eps_v (in L/T) of the smoothing."""

    mu: Any
    velocity_threshold: Any

    def holds(self) -> Any:
        return self.mu > 0.0

    def stick_speed(self) -> Any:
        # A foot's force follows its velocity the more steeply, the larger the coefficient.
        zone = self.velocity_threshold / maximum(1.0, self.mu / MODERATE)
        return where((self.mu > 0.0) & (zone >= FINEST), zone, 1e30)

    def largest_ratio(self) -> Any:
        return self.mu

    def ratio(self, velocity: Any) -> Any:
        sign, _ = regularised_sign(velocity, self.velocity_threshold)
        return self.mu * sign


class SmoothedCoulombOptions(FrictionOptions):
    """Smoothed Coulomb friction: the half width of its stick zone."""

    Law: ClassVar[Any]
    takes_arrays = True

    velocity_threshold_m_s: float = number(
        1.0e-3,
        above=0.0,
        most=1000.0,
        usual=(1e-9, 10.0),
        unit="m/s",
        doc="half width of the stick zone",
        symbol="ε_v",
        plan=(1e-4, 1e-2),
        takes_arrays=True,
    )

    def law(self, scales: Scales, mu: float) -> Any:
        """The dimensionless law."""
        return self.Law(mu, self.velocity_threshold_m_s / scales.velocity_m_s)
