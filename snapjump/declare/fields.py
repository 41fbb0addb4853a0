"""Options of modules: fields whose default, unit, range or choices are data.

A part is a frozen dataclass that checks every value, one line for a bad one (key, value, allowed
range), before any work. What a field may be stands in its ``metadata["allowed"]``.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar, NamedTuple, TypedDict, Unpack, dataclass_transform

from snapjump.checks import ParameterError, check_choice, check_integer, check_number


class Number(NamedTuple):
    """A finite number in [low, high], or in (low, high] when ``above``, or one of some words."""

    low: float
    high: float
    above: bool
    unit: str
    words: tuple[str, ...] = ()

    def check(self, key: str, value: Any) -> None:
        """Raises ParameterError."""
        if self.words and isinstance(value, str):
            if value not in self.words:
                allowed = f"a number ({self.unit}), or one of {', '.join(self.words)}"
                raise ParameterError(key, value, allowed)
            return
        check_number(key, value, self.low, self.high, above=self.above, unit=self.unit)


class Integer(NamedTuple):
    """An integer in [low, high]."""

    low: int
    high: int

    def check(self, key: str, value: Any) -> None:
        """Raises ParameterError."""
        check_integer(key, value, self.low, self.high)


class Choice(NamedTuple):
    """One of some words."""

    words: tuple[str, ...]

    def check(self, key: str, value: Any) -> None:
        """Raises ParameterError."""
        check_choice(key, value, self.words)


class Flag(NamedTuple):
    """True or false."""

    def check(self, key: str, value: Any) -> None:
        """Raises ParameterError."""
        if not isinstance(value, bool):
            raise ParameterError(key, value, "true or false")


class About(TypedDict, total=False):
    """What plans, plots and reports need to know of a number beside unit, range and meaning.

    ``symbol`` as in formulas; ``plan``: low and high of a dataset; ``kind``: of whom it is, one of
    control, environment, property; ``column``: its name in files, where that is not the field's.
    """

    symbol: str
    plan: tuple[float, float]
    kind: str
    column: str


def number(
    default: float | str,
    *,
    least: float = -math.inf,
    above: float | None = None,
    most: float = math.inf,
    unit: str = "",
    words: tuple[str, ...] = (),
    doc: str = "",
    **about: Unpack[About],
) -> Any:
    """A field that holds a number: at least, or above, so much, and at most so much; or a word."""
    low = least if above is None else above
    allowed = Number(low, most, above is not None, unit, words)
    return field(default=default, metadata={"allowed": allowed, "doc": doc, "about": about})


def integer(default: int, *, least: int, most: int, doc: str = "") -> Any:
    """A field that holds an integer."""
    return field(default=default, metadata={"allowed": Integer(least, most), "doc": doc})


def choice(default: str, words: Sequence[str], doc: str = "") -> Any:
    """A field that holds one of some words."""
    return field(default=default, metadata={"allowed": Choice(tuple(words)), "doc": doc})


def flag(default: bool, doc: str = "") -> Any:
    """A field that is true or false."""
    return field(default=default, metadata={"allowed": Flag(), "doc": doc})


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
class Part:
    """What a user chooses and sets of one group; subclasses are frozen dataclasses."""

    group: ClassVar[str]

    def __init_subclass__(cls, **words: Any) -> None:
        super().__init_subclass__(**words)
        dataclass(frozen=True)(cls)

    def __post_init__(self) -> None:
        for declared in fields(self):  # type: ignore[arg-type]
            allowed = declared.metadata.get("allowed")
            if allowed is not None:
                allowed.check(f"{self.group}.{declared.name}", getattr(self, declared.name))
