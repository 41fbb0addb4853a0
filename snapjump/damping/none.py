"""No damping: strain rates are not even computed."""

from typing import Any, NamedTuple

from snapjump.damping.base import mass_damping, viscous_stiffening, viscous_strain


class NoDamping(NamedTuple):
    """A perfectly elastic material in vacuum."""


@viscous_strain.member(NoDamping)
def _strain(damping: NoDamping, strain: Any, rate: Any) -> Any:
    return strain


@viscous_stiffening.member(NoDamping)
def _stiffening(damping: NoDamping, rate_factor: Any) -> float:
    return 1.0


@mass_damping.member(NoDamping)
def _mass(damping: NoDamping) -> float:
    return 0.0
