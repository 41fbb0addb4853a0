"""Options of the friction laws."""

from snapjump.declare.fields import Part, number
from snapjump.friction.implicit import ImplicitFriction
from snapjump.friction.lagged import LaggedFriction
from snapjump.friction.none import NoFriction
from snapjump.units import Scales


class FrictionOptions(Part):
    """A friction law and its numbers."""

    group = "friction"


class NoFrictionOptions(FrictionOptions):
    """A perfectly slippery ground."""

    def member(self, scales: Scales, mu: float) -> NoFriction:
        """The empty law."""
        return NoFriction()


class ImplicitFrictionOptions(FrictionOptions):
    """Smoothed Coulomb friction of the unknown normal force and velocity."""

    velocity_threshold_m_s: float = number(1.0e-4, above=0.0, unit="m/s")

    def member(self, scales: Scales, mu: float) -> ImplicitFriction:
        """The dimensionless law."""
        return ImplicitFriction(mu, self.velocity_threshold_m_s / scales.velocity_m_s)


class LaggedFrictionOptions(FrictionOptions):
    """Smoothed Coulomb friction of the last step's normal force and velocity (the paper)."""

    velocity_threshold_m_s: float = number(1.0e-4, above=0.0, unit="m/s")

    def member(self, scales: Scales, mu: float) -> LaggedFriction:
        """The dimensionless law."""
        return LaggedFriction(mu, self.velocity_threshold_m_s / scales.velocity_m_s)
