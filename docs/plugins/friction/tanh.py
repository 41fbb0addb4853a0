"""Friction smoothed by a hyperbolic tangent: mu tanh(v / v0), as many programs have it."""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.friction.base import FrictionLaw, FrictionOptions
from snapjump.number.exponentials import exp
from snapjump.number.functions import absolute, where
from snapjump.units import Scales


class Tanh(FrictionOptions):
    """Friction smoothed by a hyperbolic tangent, of the unknown normal force and velocity."""

    velocity_scale_m_s: float = number(1.0e-2, above=0.0, unit="m/s")

    @FrictionLaw.member
    class Law(NamedTuple):
        """Coefficient mu and velocity v0 (in L/T)."""

        mu: float
        velocity_scale: float

        def holds(self) -> Any:
            return self.mu > 0.0

        def ratio(self, velocity: Any) -> Any:
            faded = exp(-2.0 * absolute(velocity) / self.velocity_scale)
            size = self.mu * (1.0 - faded) / (1.0 + faded)
            return where(velocity > 0.0, size, -size)

    def law(self, scales: Scales, mu: float) -> Law:
        """The dimensionless law."""
        return self.Law(mu, self.velocity_scale_m_s / scales.velocity_m_s)
