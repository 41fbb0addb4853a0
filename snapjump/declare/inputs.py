"""Inputs of a simulation: every number of its physical parts, by its path (``robot.thickness_m``).

An input is a field that :func:`snapjump.declare.fields.number` declares; nothing lists it a second
time. Numerical settings (mesh, tolerance, steps) are none.
"""

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, fields, replace
from typing import Any, TypeVar

from snapjump.checks import ParameterError
from snapjump.declare.fields import Number

S = TypeVar("S")
# The parts of a simulation whose numbers are inputs.
PARTS = (
    *("robot", "design", "environment", "frame", "drive"),
    *("contact", "friction", "damping", "drag"),
)
DEFAULT_INPUTS = ("design.delta_alpha", "design.epsilon", "environment.mass_bar", "environment.mu")


@dataclass(frozen=True)
class Input:
    """A number that a robot, its design, environment or laws are described by.

    ``path``; ``column``: its name in files; ``allowed``: its range of validity and unit;
    ``meaning``, ``symbol``: for people; ``plan``: low and high of a dataset, None if it has to be
    said; ``kind``: control, environment or property, of the robot; ``default``; ``takes_arrays``:
    whether models of many robots are made of an array of it.
    """

    path: str
    column: str
    allowed: Number
    meaning: str
    symbol: str
    plan: tuple[float, float] | None
    kind: str
    default: Any
    takes_arrays: bool

    @property
    def name(self) -> str:
        """The last word of the path."""
        return self.path.rpartition(".")[2]

    @property
    def unit(self) -> str:
        return self.allowed.unit


def inputs_of(parts: Mapping[str, Any] | Any) -> dict[str, Input]:
    """The inputs, by path, of a simulation, or of parts or their classes by name."""
    found = {}
    for group in PARTS:
        part = parts.get(group) if isinstance(parts, Mapping) else getattr(parts, group)
        for field in () if part is None else fields(part):
            allowed = field.metadata.get("allowed")
            if isinstance(allowed, Number):
                path, name, get = f"{group}.{field.name}", field.name, field.metadata["about"].get
                told = field.metadata["doc"] or name, get("symbol", name)
                kind = get("plan"), get("kind", "property")
                column, many = get("column", name), get("takes_arrays", False)
                found[path] = Input(path, column, allowed, *told, *kind, field.default, many)
    return found


def input_at(parts: Mapping[str, Any] | Any, path: str, key: str = "inputs") -> Input:
    """The input at a path. Raises ParameterError, which names those that there are."""
    found = inputs_of(parts)
    if path not in found:
        raise ParameterError(key, path, "one of " + ", ".join(found))
    return found[path]


def column_names(inputs: Sequence[Input]) -> list[str]:
    """Their names in files: the whole path where two would be called alike."""
    return _distinct(inputs, [one.column for one in inputs])


def slope_names(inputs: Sequence[Input]) -> list[str]:
    """Names of inputs in those of derivatives: the last word of the path, if it is enough."""
    return _distinct(inputs, [one.name for one in inputs])


def _distinct(inputs: Sequence[Input], names: Sequence[str]) -> list[str]:
    """The names, the whole path as one word where two are alike."""
    paths = [one.path.replace(".", "_") for one in inputs]
    return [n if names.count(n) == 1 else p for n, p in zip(names, paths, strict=True)]


def value_at(simulation: Any, path: str) -> Any:
    """The value of an input: a number, or the word that stands for one."""
    group, _, name = path.partition(".")
    return getattr(getattr(simulation, group), name)


def with_inputs(simulation: S, values: Mapping[str, float]) -> S:
    """The simulation with other values of some inputs, by path.
    Raises ParameterError for a value out of its range, or one that does not go with the others."""
    changes: dict[str, dict[str, float]] = {}
    for path, value in values.items():
        group, _, name = path.partition(".")
        changes.setdefault(group, {})[name] = float(value)
    parts = {group: replace(getattr(simulation, group), **new) for group, new in changes.items()}
    return replace(simulation, **parts)  # type: ignore[type-var]


def with_columns(simulation: S, columns: Mapping[str, Any]) -> S:
    """Many simulations as one, in which some inputs, by path, are arrays (R).

    Here alone nothing is checked: fields know single numbers. Whoever calls sees to it that all
    values are allowed, and that whatever is asked of the simulation takes arrays.
    """
    many = copy(simulation)
    for path, values in columns.items():
        group, _, name = path.partition(".")
        part = copy(getattr(many, group))
        object.__setattr__(part, name, values)
        object.__setattr__(many, group, part)
    return many


def unusual(simulation: Any) -> list[str]:
    """A line for each input that is far from what is built, as where mm or GPa are typed."""
    found = []
    for group in PARTS:
        part = getattr(simulation, group)
        for field in fields(part):
            value, usual = getattr(part, field.name), field.metadata.get("about", {}).get("usual")
            if usual and isinstance(value, float) and not usual[0] <= value <= usual[1]:
                unit = f" {field.metadata['allowed'].unit}".rstrip()
                span = f"[{usual[0]:g}, {usual[1]:g}]{unit}"
                found.append(f"{group}.{field.name} = {value:g}{unit} is unusual: not in {span}")
    return found


def check_inputs(simulation: Any, paths: Iterable[str]) -> None:
    """Raise ParameterError for a path that is no input of the simulation, or is there twice."""
    seen = set()
    for path in paths:
        input_at(simulation, path)
        if path in seen:
            raise ParameterError("inputs", path, "every input once")
        seen.add(path)
