"""Mass-proportional damping: a drag on every mass, as in the released program."""

from typing import Any, NamedTuple

from snapjump.damping.base import mass_damping, viscous_stiffening, viscous_strain


class MassProportional(NamedTuple):
    """Drag coefficient (in 1/T)."""

    rate: float


@viscous_strain.member(MassProportional)
def _strain(damping: MassProportional, strain: Any, rate: Any) -> Any:
    return strain


@viscous_stiffening.member(MassProportional)
def _stiffening(damping: MassProportional, rate_factor: Any) -> float:
    return 1.0


@mass_damping.member(MassProportional)
def _mass(damping: MassProportional) -> Any:
    return damping.rate
