"""Options of the friction laws."""

from dataclasses import dataclass

from snapjump.checks import check_number
from snapjump.friction.implicit import ImplicitFriction
from snapjump.friction.lagged import LaggedFriction
from snapjump.friction.none import NoFriction
from snapjump.units import Scales


@dataclass(frozen=True)
class NoFrictionOptions:
    """A perfectly slippery ground."""

    def member(self, scales: Scales, mu: float) -> NoFriction:
        """The empty law."""
        return NoFriction()


@dataclass(frozen=True)
class ImplicitFrictionOptions:
    """Smoothed Coulomb friction of the unknown normal force and velocity."""

    velocity_threshold_m_s: float = 1.0e-4

    def __post_init__(self) -> None:
        check_number(
            "friction.velocity_threshold_m_s",
            self.velocity_threshold_m_s,
            0.0,
            above=True,
            unit="m/s",
        )

    def member(self, scales: Scales, mu: float) -> ImplicitFriction:
        """The dimensionless law."""
        return ImplicitFriction(mu, self.velocity_threshold_m_s / scales.velocity_m_s)


@dataclass(frozen=True)
class LaggedFrictionOptions:
    """Smoothed Coulomb friction of the last step's normal force and velocity (the paper)."""

    velocity_threshold_m_s: float = 1.0e-4

    def __post_init__(self) -> None:
        check_number(
            "friction.velocity_threshold_m_s",
            self.velocity_threshold_m_s,
            0.0,
            above=True,
            unit="m/s",
        )

    def member(self, scales: Scales, mu: float) -> LaggedFriction:
        """The dimensionless law."""
        return LaggedFriction(mu, self.velocity_threshold_m_s / scales.velocity_m_s)
