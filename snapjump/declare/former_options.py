"""Options of before: what has become of a key, in configurations that are kept and by hand.

A kept configuration, of a dataset, a checkpoint or a study's cell, is read under the names of
today; on a command line the old name is refused with the new one. A key that a kept configuration
lacks counts as its default.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from snapjump.checks import ParameterError


class Former(NamedTuple):
    """The present path of a former key (empty: it is gone), in words, and its value there."""

    path: str
    words: str
    value: Callable[[Any], Any] = lambda value: value


FORMER = {
    "linear_solver": Former("", "left out: there is one linear solver, which nothing chooses"),
    "robot.rotation_rate_rad_s": Former("drive.rate_rad_s", "drive.rate_rad_s now"),
    "robot.rotation_end_rad": Former("drive.end_rad", "drive.end_rad now"),
    "sim.rise_time_s": Former(
        "drive.rise_time_s", "drive.rise_time_s now, of drive=smooth_start, which sim=snap chooses"
    ),
    "sim.incline": Former(
        "environment.slope_rad",
        "environment.slope_rad now: minus the arctangent of it",
        lambda tangent: 0.0 - math.atan(tangent),
    ),
}


def with_present_options(config: Mapping[str, Any]) -> dict[str, Any]:
    """The groups of a kept configuration under the names of today."""
    found = {key: dict(v) if isinstance(v, Mapping) else v for key, v in config.items()}
    for old, new in FORMER.items():
        group, _, key = old.partition(".")
        if not key:
            found.pop(group, None)
        elif isinstance(found.get(group), dict) and key in found[group]:
            part, _, name = new.path.partition(".")
            found[part] = {**(found.get(part) or {}), name: new.value(found[group].pop(key))}
    return found


def check_arguments(arguments: Sequence[str]) -> None:
    """Raise ParameterError for an argument of a command line that has an old name."""
    for argument in arguments:
        key, _, value = argument.partition("=")
        key = key.lstrip("+~").partition("@")[0]
        for old, new in FORMER.items():
            if key == old or key.startswith(f"{old}."):
                raise ParameterError(key, value, new.words)
