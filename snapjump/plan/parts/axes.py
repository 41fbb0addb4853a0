"""The axes of a plan: inputs with the range that a dataset takes them from."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from snapjump.checks import ParameterError, is_finite_number
from snapjump.declare.inputs import (
    DEFAULT_INPUTS,
    Input,
    column_names,
    input_at,
    inputs_of,
    slope_names,
    with_inputs,
)
from snapjump.robot.design import Design
from snapjump.robot.environment import Environment

Range = tuple[float, float]
LABELS_IN_A_ROW = 140  # characters of labels of one length that have room side by side


@dataclass(frozen=True)
class Axis:
    """An input and its range [low, high]; plain, so that files can tell all of it.

    ``column``: of its values, in files; ``slope``: what derivatives by it are called after there.
    """

    path: str
    column: str
    slope: str
    unit: str
    symbol: str
    meaning: str
    kind: str
    low: float
    high: float

    @property
    def range(self) -> Range:
        return self.low, self.high

    @property
    def short(self) -> str:
        """Symbol and unit, for pictures."""
        return f"{self.symbol} ({self.unit})" if self.unit else self.symbol

    @property
    def label(self) -> str:
        """Meaning, symbol and unit, for pictures."""
        return self.short if self.meaning == self.symbol else f"{self.meaning} {self.short}"


def labels_of(axes: Sequence[Axis]) -> list[str]:
    """Labels of pictures side by side, one an axis: without meanings where these have no room."""
    labels = [axis.label for axis in axes]
    roomy = max(map(len, labels)) * len(labels) <= LABELS_IN_A_ROW
    return labels if roomy else [axis.short for axis in axes]


def axes_of(inputs: Sequence[Input], ranges: Sequence[Range]) -> tuple[Axis, ...]:
    """The axes of inputs over these ranges."""
    names = zip(inputs, column_names(inputs), slope_names(inputs), ranges, strict=True)
    return tuple(
        Axis(one.path, column, slope, one.unit, one.symbol, one.meaning, one.kind, *limits)
        for one, column, slope, limits in names
    )


def planned(
    simulation: Any, given: Mapping[str, Range | None], keys: Mapping[str, str]
) -> tuple[Axis, ...]:
    """The axes of a plan that gives each input its range, or None for the declared one.

    ``keys``: by path, what errors call it. Raises ParameterError for a path that is no input of the
    simulation, a range that has to be given, and one whose ends are no such robot.
    """
    inputs, ranges = [], []
    for path, limits in given.items():
        one = input_at(simulation, path, "plan.inputs")
        limits = limits or one.plan
        if limits is None:
            raise ParameterError(keys[path], None, "a range [low, high]: none is declared")
        for end in limits:
            check_end(simulation, path, end, keys[path], limits)
        inputs.append(one)
        ranges.append(limits)
    return axes_of(inputs, ranges)


def check_end(simulation: Any, path: str, end: float, key: str, limits: Range) -> None:
    """Raise ParameterError, for the range, where the robot at one end of it is refused."""
    try:
        with_inputs(simulation, {path: end})
    except ParameterError as error:
        allowed = error.allowed if error.key == path else str(error)
        raise ParameterError(key, list(limits), f"[low, high], each {allowed}") from None


def checked_range(key: str, given: Any) -> Range:
    """Low and high as floats. Raises ParameterError."""
    allowed = "two numbers [low, high], low below high"
    pair = isinstance(given, (list, tuple)) and len(given) == 2
    if not (pair and all(map(is_finite_number, given)) and given[0] < given[1]):
        raise ParameterError(key, given, allowed)
    return float(given[0]), float(given[1])


def default_axes(ranges: Sequence[Range] | None = None) -> tuple[Axis, ...]:
    """The axes of the four inputs, which is what files mean that name none; None: over the ranges
    that are declared."""
    known = inputs_of({"design": Design, "environment": Environment})
    inputs = [known[path] for path in DEFAULT_INPUTS]
    return axes_of(inputs, ranges or [one.plan for one in inputs if one.plan is not None])


def recorded_axes(plain: Mapping[str, Any]) -> tuple[Axis, ...]:
    """The axes of a dataset, from its plain specification, or of what a checkpoint was trained on;
    the four, where these name none."""
    if "inputs" in plain:
        return tuple(Axis(**one) for one in plain["inputs"])
    if "ranges" in plain:
        return default_axes([(low, high) for low, high in plain["ranges"]])
    return default_axes([tuple(plain["plan"][axis.column]) for axis in default_axes()])
