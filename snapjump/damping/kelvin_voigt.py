"""Kelvin-Voigt damping: a stress eta d(strain)/dt times the elastic stiffness.

Implicit Euler with step h damps, to leading order, like eta = h.
"""

from typing import Any, NamedTuple

from snapjump.damping.base import DampingLaw


@DampingLaw.member
class KelvinVoigt(NamedTuple):
    """Relaxation time eta (in T)."""

    relaxation_time: float

    def viscous_strain(self, strain: Any, rate: Any) -> Any:
        return strain + self.relaxation_time * rate

    def stiffening(self, rate_factor: Any) -> Any:
        return 1.0 + self.relaxation_time * rate_factor
