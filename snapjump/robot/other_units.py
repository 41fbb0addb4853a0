"""Units of the workbench, degrees, grams and millimetres, for numbers that are kept in others."""

import math
from collections.abc import Callable, Collection, Mapping
from typing import Any, NamedTuple

from snapjump.checks import ParameterError, is_finite_number
from snapjump.declare.inputs import inputs_of
from snapjump.robot.design import Design
from snapjump.robot.environment import Environment, mass_bar
from snapjump.robot.robot import Robot


class OtherUnit(NamedTuple):
    """A number by another key: ``path``, in ``unit``; ``of``: the key that it stands for; ``size``:
    what one of its units is there, which may depend on the robot."""

    path: str
    of: str
    unit: str
    size: Callable[[Robot], float]


OTHER_UNITS = (
    OtherUnit(
        "design.delta_alpha_deg", "design.delta_alpha", "deg", lambda robot: math.radians(1.0)
    ),
    OtherUnit(
        "environment.mass_g", "environment.mass_bar", "g", lambda robot: mass_bar(1e-3, robot)
    ),
    OtherUnit("target_mm", "target", "mm", lambda robot: 1e-3 / robot.length_m),
)
ALLOWED = inputs_of({"design": Design, "environment": Environment})


def in_own_units(config: Mapping[str, Any], given: Collection[str], robot: Robot) -> dict[str, Any]:
    """A configuration whose numbers are all by their own keys.

    ``given``: the keys that were said, of which two may not be one number; others have defaults.
    Raises ParameterError.
    """
    converted = {
        key: dict(group) if isinstance(group, Mapping) else group for key, group in config.items()
    }
    for other in OTHER_UNITS:
        group, _, name = other.path.rpartition(".")
        place = converted.get(group) if group else converted
        value = place.pop(name, None) if isinstance(place, dict) else None
        if value is None or not isinstance(place, dict):
            continue
        if other.of in given:
            allowed = f"left out where {other.of} is given, which is the same number"
            raise ParameterError(other.path, value, allowed)
        if other.of == "target" and not isinstance(value, (list, tuple)):
            raise ParameterError(other.path, value, "[x, y] of an apex in mm")
        place[other.of.rpartition(".")[2]] = own(other, value, robot)
    return converted


def own(other: OtherUnit, value: Any, robot: Robot) -> Any:
    """A value, or a list of them, as the number that it stands for. Raises ParameterError."""
    if isinstance(value, (list, tuple)):
        return [own(other, each, robot) for each in value]
    if not is_finite_number(value):
        raise ParameterError(other.path, value, f"a number of {other.unit}")
    found = float(value) * other.size(robot)
    if other.of in ALLOWED:
        try:
            ALLOWED[other.of].allowed.check(other.of, found)
        except ParameterError as error:
            allowed = f"{error.allowed}, and {found:.6g} is what it comes to"
            raise ParameterError(other.path, value, f"{other.of} as {allowed}") from None
    return found


def in_other_units(path: str, value: float, robot: Robot) -> str:
    """A number in the unit of the workbench, as in ``5.73 deg``; empty where there is no other."""
    for other in OTHER_UNITS:
        if other.of == path:
            return f"{value / other.size(robot):.4g} {other.unit}"
    return ""
