"""A dead force and a moment at the free end of a cantilever."""

from typing import Any, NamedTuple

from snapjump.load.base import gravity, pull, tip_load


class TipLoad(NamedTuple):
    """Force components (EI/L^2) and moment (EI/L) at the last node."""

    force_x: float
    force_y: float
    moment: float


@gravity.member(TipLoad)
def _gravity(load: TipLoad) -> float:
    return 0.0


@tip_load.member(TipLoad)
def _tip(load: TipLoad) -> Any:
    return load.force_x, load.force_y, load.moment


@pull.member(TipLoad)
def _pull(load: TipLoad) -> float:
    return 0.0
