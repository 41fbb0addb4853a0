"""The table of tolerances: how far an input may be off, or which members of a family may be meant.

Those of the laws are what different sources say of one robot, those of the robot what a workshop
keeps; they are limits, not standard deviations.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

from snapjump.checks import ParameterError
from snapjump.composition import PLAIN
from snapjump.declare.families import FAMILIES
from snapjump.declare.fields import Number
from snapjump.declare.inputs import PARTS, inputs_of
from snapjump.declare.members import member_class, member_names

KEY = "uncertainty.tolerances"
LAWS = tuple(family for family in FAMILIES if family in PARTS)  # families that are of the robot
FACTOR, RELATIVE, ABSOLUTE, MEMBERS = "factor", "relative", "absolute", "members"
SIZES = {
    FACTOR: Number(1.0, 1e6, True, ""),
    RELATIVE: Number(0.0, 0.99, True, ""),
    ABSOLUTE: Number(0.0, 1e20, True, ""),
}
DEFAULTS: Mapping[str, Mapping[str, Any]] = {
    "robot.thickness_m": {RELATIVE: 0.02},
    "robot.youngs_modulus_Pa": {RELATIVE: 0.03},
    "robot.mount_height": {ABSOLUTE: 1e-4},
    "frame.mass_centre_height_m": {ABSOLUTE: 1e-3},
    "damping.relaxation_time_s": {FACTOR: 3.0},
    "contact.stiffness_N_m": {FACTOR: 3.0},
    "contact.distance_m": {FACTOR: 2.0},
    "drag": {MEMBERS: ["none", "quadratic"]},
}


class Tolerance(NamedTuple):
    """An input may be so much larger or smaller: by a factor, by a share of itself, or by as much
    in its unit."""

    how: str
    size: float

    def ends(self, value: float) -> tuple[float, float]:
        """The least and the largest that it may be."""
        if self.how == FACTOR:
            first, last = value / self.size, value * self.size
        else:
            half = self.size * abs(value) if self.how == RELATIVE else self.size
            first, last = value - half, value + half
        return min(first, last), max(first, last)

    def told(self, unit: str) -> str:
        """In words, as in ``2 %``."""
        if self.how == FACTOR:
            return f"factor {self.size:g}"
        return f"{100.0 * self.size:g} %" if self.how == RELATIVE else f"{self.size:g} {unit}"


class Choice(NamedTuple):
    """Any of some members of a family may be meant."""

    members: tuple[str, ...]


def checked(given: Mapping[str, Any] | None) -> dict[str, Tolerance | Choice]:
    """The table with what is given in place of its defaults, by path or family; what is None is
    left out. Raises ParameterError."""
    rows = {name: row_of(name, row) for name, row in {**DEFAULTS, **(given or {})}.items()}
    return {name: row for name, row in rows.items() if row is not None}


def row_of(name: str, row: Any) -> Tolerance | Choice | None:
    """One row of the table, None for one that is left out. Raises ParameterError."""
    key, (kinds, allowed) = f"{KEY}.{name}", kinds_of(name)
    if row is None:
        return None
    if not isinstance(row, Mapping) or len(row) != 1 or next(iter(row)) not in kinds:
        raise ParameterError(key, row, f"null, or {allowed}")
    ((how, size),) = row.items()
    if how != MEMBERS:
        SIZES[how].check(f"{key}.{how}", size)
        return Tolerance(how, float(size))
    known = member_names(name)
    if not isinstance(size, (list, tuple)) or not size or any(one not in known for one in size):
        raise ParameterError(f"{key}.{how}", size, f"a list of {', '.join(known)}")
    return Choice(tuple(size))


def kinds_of(name: str) -> tuple[tuple[str, ...], str]:
    """Which words a row of a name may have, and as they are told. Raises ParameterError for one
    that is neither an input of any member nor a family."""
    if name in LAWS:
        return (MEMBERS,), "{members: [...]} of the family"
    group = str(name).partition(".")[0]
    classes = [PLAIN[group]] if group in PLAIN else []
    if group in LAWS:
        classes = [member_class(group, member) for member in member_names(group)]
    if not any(name in inputs_of({group: each}) for each in classes):
        allowed = f"paths of inputs, as robot.thickness_m, or families: {', '.join(LAWS)}"
        raise ParameterError(KEY, name, allowed)
    return tuple(SIZES), "one of {factor: ...}, {relative: ...}, {absolute: ...}"
