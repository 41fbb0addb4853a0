"""Options of the damping laws."""

from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.declare.fields import Part, number
from snapjump.units import Scales


class DampingOptions(Part):
    """A damping law and its numbers."""

    group = "damping"


class NoDampingOptions(DampingOptions):
    """A perfectly elastic material."""

    def member(self, scales: Scales) -> NoDamping:
        """The empty law."""
        return NoDamping()


class KelvinVoigtOptions(DampingOptions):
    """Material damping: a stress eta d(strain)/dt; implicit Euler at h = eta damps alike."""

    relaxation_time_s: float = number(1.0e-5, least=0.0, unit="s")

    def member(self, scales: Scales) -> KelvinVoigt:
        """The dimensionless law."""
        return KelvinVoigt(self.relaxation_time_s / scales.time_s)


class MassProportionalOptions(DampingOptions):
    """A drag on every mass (the released program: 0.01 1/s)."""

    rate_1_s: float = number(0.01, least=0.0, unit="1/s")

    def member(self, scales: Scales) -> MassProportional:
        """The dimensionless law."""
        return MassProportional(self.rate_1_s * scales.time_s)
