"""Options of modules: fields whose default, unit, range or choices are data.

A part is a frozen dataclass that checks every value, one line for a bad one (key, value, allowed
range), before any work. What a field may be stands in its ``metadata["allowed"]``.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields, replace
from typing import Any, ClassVar, NamedTuple, Self, TypedDict, Unpack, dataclass_transform

import numpy as np
from numpy.typing import NDArray

from snapjump.checks import ParameterError, check_group, check_integer, check_number


class Number(NamedTuple):
    """A finite number in [low, high], or in (low, high] when ``above``, or one of some words.

    What may be in a field: ``check`` raises ParameterError, ``plain`` is what is kept of a value.
    """

    low: float
    high: float
    above: bool
    unit: str
    words: tuple[str, ...] = ()

    def check(self, key: str, value: Any) -> None:
        if self.words and isinstance(value, str):
            if value not in self.words:
                allowed = f"a number ({self.unit}), or one of {', '.join(self.words)}"
                raise ParameterError(key, value, allowed)
            return
        check_number(key, value, self.low, self.high, above=self.above, unit=self.unit)

    def allows(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which of many numbers (R) ``check`` lets pass."""
        enough = values > self.low if self.above else values >= self.low
        return np.isfinite(values) & enough & (values <= self.high)

    def plain(self, value: Any) -> Any:
        """A float for every number: a program is compiled for each kind of number it is given."""
        return value if isinstance(value, str) else float(value)


class Integer(NamedTuple):
    """An integer in [low, high]."""

    low: int
    high: int

    def check(self, key: str, value: Any) -> None:
        check_integer(key, value, self.low, self.high)

    def plain(self, value: Any) -> int:
        return int(value)


class Choice(NamedTuple):
    """One of some words, or of some integers."""

    words: tuple[str | int, ...]

    def check(self, key: str, value: Any) -> None:
        if type(value) is not type(self.words[0]) or value not in self.words:
            raise ParameterError(key, value, "one of " + ", ".join(map(str, self.words)))

    def plain(self, value: Any) -> Any:
        return value


class Flag(NamedTuple):
    """True or false."""

    def check(self, key: str, value: Any) -> None:
        if not isinstance(value, bool):
            raise ParameterError(key, value, "true or false")

    def plain(self, value: Any) -> Any:
        return value


class About(TypedDict, total=False):
    """Attributes of a number for plans, plots and reports, beside unit, range and meaning.

    ``symbol`` as in formulas; ``plan``: low and high of a dataset; ``kind``: of whom it is, one of
    control, environment, property; ``column``: its name in files, where that is not the field's;
    ``usual``: least and largest of what is built, beyond which another unit may be meant.
    ``takes_arrays``: whether models are made of it by arithmetic alone, which makes those of many
    robots of an array, and nothing but its range is checked.
    """

    symbol: str
    plan: tuple[float, float]
    kind: str
    column: str
    usual: tuple[float, float]
    takes_arrays: bool


def number(
    default: Any = MISSING,
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


def integer(default: Any = MISSING, *, least: int, most: int, doc: str = "") -> Any:
    """A field that holds an integer, or None if that is the default."""
    return field(default=default, metadata={"allowed": Integer(least, most), "doc": doc})


def choice(default: str | int, words: Sequence[str | int], doc: str = "") -> Any:
    """A field that holds one of some words or integers."""
    return field(default=default, metadata={"allowed": Choice(tuple(words)), "doc": doc})


def flag(default: bool, doc: str = "") -> Any:
    """A field that is true or false."""
    return field(default=default, metadata={"allowed": Flag(), "doc": doc})


def hidden(default: Any) -> Any:
    """A field that is no setting of a user's."""
    return field(default=default, metadata={"hidden": True})


def required(function: Any) -> Any:
    """A method that every member must write."""
    function.is_required = True
    return function


class Need(NamedTuple):
    """A capability that a member needs of another family's, and why: an attribute that is true."""

    family: str
    capability: str
    why: str = ""


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
class Part:
    """Options of one group, checked; subclasses are frozen dataclasses.

    ``given``: names of the fields that were set, and not left to their defaults.
    ``differentiable``: whether sensitivities know the member.
    """

    group: ClassVar[str]
    needs: ClassVar[tuple[Need, ...]] = ()
    differentiable: ClassVar[bool] = True
    given: ClassVar[frozenset[str]]

    def __init_subclass__(cls, **words: Any) -> None:
        super().__init_subclass__(**words)
        dataclass(frozen=True)(cls)

    def __new__(cls, *values: Any, **named: Any) -> Self:
        part = super().__new__(cls)
        names = [declared.name for declared in fields(cls)]  # type: ignore[arg-type]
        object.__setattr__(part, "given", frozenset((*names[: len(values)], *named)))
        return part

    @property
    def name(self) -> str:
        """The member's name in its family: that of its file."""
        return type(self).__module__.rpartition(".")[2]

    def check_with(self, simulation: Any) -> None:
        """Raises ParameterError for a simulation whose other parts do not suit this one."""

    def changed(self, **values: Any) -> Self:
        """A copy with other values of some fields, which are given. Raises ParameterError."""
        part = replace(self, **values)  # type: ignore[type-var]
        object.__setattr__(part, "given", self.given | frozenset(values))
        return part

    def with_defaults(self, values: Mapping[str, Any]) -> Self:
        """A copy with other values of fields that were not given. Raises ParameterError."""
        names = [declared.name for declared in fields(self)]  # type: ignore[arg-type]
        other = {k: v for k, v in values.items() if k in names and k not in self.given}
        if not other:
            return self
        part = replace(self, **other)  # type: ignore[type-var]
        object.__setattr__(part, "given", self.given)
        return part

    def __post_init__(self) -> None:
        for declared in fields(self):  # type: ignore[arg-type]
            value, allowed = getattr(self, declared.name), declared.metadata.get("allowed")
            if allowed is not None and not (value is None and declared.default is None):
                allowed.check(f"{self.group}.{declared.name}", value)
                object.__setattr__(self, declared.name, allowed.plain(value))


def settings(part: Any) -> list[str]:
    """Names of the fields that a user sets, of a part or any dataclass."""
    return [declared.name for declared in fields(part) if "hidden" not in declared.metadata]


def construct(group: str, cls: Any, values: Any) -> Any:
    """A part, or any dataclass, from a group's values; what is left out has its default.
    Raises ParameterError for an unknown key, and for a missing one that has no default."""
    check_group(group, values)
    declared = {f.name: f for f in fields(cls) if "hidden" not in f.metadata}
    for key, value in values.items():
        if key not in declared:
            allowed = ", ".join(declared) or "no keys at all"
            raise ParameterError(f"{group}.{key}", value, f"{group} has {allowed}")
    for key, field_ in declared.items():
        if key not in values and field_.default is MISSING and field_.default_factory is MISSING:
            raise ParameterError(f"{group}.{key}", None, "a value, which cannot be left out")
    return cls(**values)
