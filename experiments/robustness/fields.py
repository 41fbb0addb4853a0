"""Every value that a user can set, and values that it must not have: what invalid input is made of.

The range of a number is what its field declares, so that a member that is added is covered as it
is.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.declare.families import FAMILIES
from snapjump.declare.fields import Integer, Number, settings
from snapjump.declare.members import member_class, member_names
from snapjump.simulation import PLAIN

NOT_NUMBERS: tuple[Any, ...] = ("much", "", "1e-5", None, [1.0], {"a": 1.0}, True, 1j, 10**400)
NOT_WORDS: tuple[Any, ...] = ("", "no such word", None, 3, -1.0, ["optimal"], {}, True)
NOT_ROWS: tuple[Any, ...] = (5, "rows", [], [[0.0]], [[1.0], [0.0, 1.0]], [[0.0], [0.5, -0.5]])
NOT_WEIGHTS: tuple[Any, ...] = (5, "weights", [], [1.0], {"a": 1.0})
NOT_FINITE = (math.nan, math.inf, -math.inf)


@dataclass(frozen=True)
class Field:
    """A value of a group (of the member ``name`` of a family), its default and its range.
    ``low``, ``high``: of a number, NaN for anything else; ``open_low``: ``low`` is not allowed."""

    group: str
    name: str
    key: str
    default: Any
    low: float = math.nan
    high: float = math.nan
    open_low: bool = False

    @property
    def is_number(self) -> bool:
        return not math.isnan(self.low)


def all_fields() -> list[Field]:
    """Every field of robot, design, environment and every member of every family."""
    found = []
    for group, cls in PLAIN.items():
        found += _fields(group, "", cls)
    for family in FAMILIES:
        for name in member_names(family):
            found += _fields(family, name, member_class(family, name))
    return found


def _fields(group: str, name: str, cls: Any) -> list[Field]:
    found, part = [], cls()
    for key in settings(part):
        allowed = type(part).__dataclass_fields__[key].metadata.get("allowed")
        limits = allowed[:3] if isinstance(allowed, (Number, Integer)) else ()
        found.append(Field(group, name, key, getattr(part, key), *limits))
    return found


def one_of(random: np.random.Generator, things: Sequence[Any]) -> Any:
    """One of some things."""
    return things[int(random.integers(len(things)))]


def wrong_type(field: Field, random: np.random.Generator) -> Any:
    """A value of a wrong type or, for a word, another word."""
    if field.is_number:
        # What may be left out is None.
        choices = tuple(one for one in NOT_NUMBERS if one is not None or field.default is not None)
    elif field.key == "rows":
        choices = NOT_ROWS
    elif field.key in ("weights", "embedded"):
        choices = NOT_WEIGHTS
    else:
        choices = NOT_WORDS
    if isinstance(field.default, bool):
        choices = tuple(value for value in choices if not isinstance(value, bool))
    return one_of(random, choices)


def outside(field: Field, random: np.random.Generator) -> float | int:
    """A number just or far outside the range."""
    sides = [s for s in (field.low, field.high) if math.isfinite(s)]
    side = one_of(random, sides)
    if side == field.low and field.open_low and random.random() < 0.3:
        return side
    far = 10.0 ** random.uniform(-6.0, 6.0) * max(abs(side), 1e-9)
    value = side - far if side == field.low else side + far
    if not isinstance(field.default, int):
        return value
    return math.floor(value) if side == field.low else math.ceil(value)
