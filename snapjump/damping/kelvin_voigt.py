"""Kelvin-Voigt damping: a stress eta d(strain)/dt times the elastic stiffness.

Implicit Euler with step h damps, to leading order, like eta = h.
"""

from typing import Any, NamedTuple

from snapjump.damping.base import DampingLaw, DampingOptions
from snapjump.declare.fields import number
from snapjump.units import Scales


class KelvinVoigt(DampingOptions):
    """Material damping: a stress eta d(strain)/dt; implicit Euler at h = eta damps alike."""

    relaxation_time_s: float = number(
        1.0e-5,
        least=0.0,
        unit="s",
        doc="relaxation time of the material",
        symbol="η",
        plan=(1e-6, 2e-5),
        usual=(0.0, 0.01),
        takes_arrays=True,
    )

    @DampingLaw.member
    class Law(NamedTuple):
        """Relaxation time eta (in T)."""

        relaxation_time: float

        def viscous_strain(self, strain: Any, rate: Any) -> Any:
            return strain + self.relaxation_time * rate

        def stiffening(self, rate_factor: Any) -> Any:
            return 1.0 + self.relaxation_time * rate_factor

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        return self.Law(self.relaxation_time_s / scales.time_s)

    def relaxation_s(self) -> float:
        return self.relaxation_time_s
