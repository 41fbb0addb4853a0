"""Options of the damping laws."""

from dataclasses import dataclass

from snapjump.checks import check_number
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.units import Scales


@dataclass(frozen=True)
class NoDampingOptions:
    """A perfectly elastic material."""

    def member(self, scales: Scales) -> NoDamping:
        """The empty law."""
        return NoDamping()


@dataclass(frozen=True)
class KelvinVoigtOptions:
    """Material damping: a stress eta d(strain)/dt; implicit Euler at h = eta damps alike."""

    relaxation_time_s: float = 1.0e-5

    def __post_init__(self) -> None:
        check_number("damping.relaxation_time_s", self.relaxation_time_s, 0.0, unit="s")

    def member(self, scales: Scales) -> KelvinVoigt:
        """The dimensionless law."""
        return KelvinVoigt(self.relaxation_time_s / scales.time_s)


@dataclass(frozen=True)
class MassProportionalOptions:
    """A drag on every mass (the released program: 0.01 1/s)."""

    rate_1_s: float = 0.01

    def __post_init__(self) -> None:
        check_number("damping.rate_1_s", self.rate_1_s, 0.0, unit="1/s")

    def member(self, scales: Scales) -> MassProportional:
        """The dimensionless law."""
        return MassProportional(self.rate_1_s * scales.time_s)
