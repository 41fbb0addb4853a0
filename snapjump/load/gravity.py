"""Weight."""

from typing import Any, NamedTuple

from snapjump.load.base import gravity, pull, tip_load


class Gravity(NamedTuple):
    """Downward acceleration (in L/T^2)."""

    acceleration: float


@gravity.member(Gravity)
def _gravity(load: Gravity) -> Any:
    return load.acceleration


@tip_load.member(Gravity)
def _tip(load: Gravity) -> Any:
    return 0.0, 0.0, 0.0


@pull.member(Gravity)
def _pull(load: Gravity) -> float:
    return 0.0
