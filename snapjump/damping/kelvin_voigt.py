"""Kelvin-Voigt damping: a stress eta d(strain)/dt times the elastic stiffness.

Implicit Euler with step h damps, to leading order, like eta = h.
"""

from typing import Any, NamedTuple

from snapjump.damping.base import mass_damping, viscous_stiffening, viscous_strain


class KelvinVoigt(NamedTuple):
    """Relaxation time eta (in T)."""

    relaxation_time: float


@viscous_strain.member(KelvinVoigt)
def _strain(damping: KelvinVoigt, strain: Any, rate: Any) -> Any:
    return strain + damping.relaxation_time * rate


@viscous_stiffening.member(KelvinVoigt)
def _stiffening(damping: KelvinVoigt, rate_factor: Any) -> Any:
    return 1.0 + damping.relaxation_time * rate_factor


@mass_damping.member(KelvinVoigt)
def _mass(damping: KelvinVoigt) -> float:
    return 0.0
