"""No load."""

from typing import Any, NamedTuple

from snapjump.load.base import gravity, pull, tip_load


class NoLoad(NamedTuple):
    """Weightless and unloaded."""


@gravity.member(NoLoad)
def _gravity(load: NoLoad) -> float:
    return 0.0


@tip_load.member(NoLoad)
def _tip(load: NoLoad) -> Any:
    return 0.0, 0.0, 0.0


@pull.member(NoLoad)
def _pull(load: NoLoad) -> float:
    return 0.0
