"""Weight on a slope: gravity's components across and along the ground."""

from typing import Any, NamedTuple

from snapjump.load.base import gravity, pull, tip_load


class InclinedGravity(NamedTuple):
    """Accelerations into the ground and along +x (in L/T^2)."""

    normal: float
    tangential: float


@gravity.member(InclinedGravity)
def _gravity(load: InclinedGravity) -> Any:
    return load.normal


@pull.member(InclinedGravity)
def _pull(load: InclinedGravity) -> Any:
    return load.tangential


@tip_load.member(InclinedGravity)
def _tip(load: InclinedGravity) -> Any:
    return 0.0, 0.0, 0.0
