"""The contract of a plan: numbered designs, of which any stretch can be had on its own."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.declare.fields import Part, integer, required, settings
from snapjump.declare.members import member_group
from snapjump.plan.parts.axes import Axis, Range, checked_range, default_axes, planned


def stretched(unit: Array, ranges: tuple[Range, ...]) -> Array:
    """Points of the unit cube (N, I) in the box of the ranges."""
    low, high = np.array(ranges).T
    return low + (high - low) * unit


MOST_DESIGNS = 2**30
LARGEST_SEED = 2**32 - 1
# What the four inputs are called where ``inputs`` is null.
KEYS = {axis.path: axis.column for axis in default_axes()}


class PlanOptions(Part):
    """The box that designs are taken from: [low, high] of each input, None for the declared one.

    ``inputs``: by path, any inputs in the order of their columns; None: the four, each of which
    has a key of its own.
    """

    group = "plan"

    inputs: Mapping[str, Range | None] | None = None
    delta_alpha_rad: Range | None = None
    epsilon: Range | None = None
    mass_bar: Range | None = None
    mu: Range | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        for key in KEYS.values():
            given = getattr(self, key)
            if given is not None:
                object.__setattr__(self, key, checked_range(f"plan.{key}", given))
                if self.inputs is not None:
                    raise ParameterError(f"plan.{key}", given, "null together with plan.inputs")
        if self.inputs is not None:
            object.__setattr__(self, "inputs", checked_inputs(self.inputs))

    def axes(self, simulation: Any) -> tuple[Axis, ...]:
        """The inputs of the simulation that vary, and their ranges. Raises ParameterError."""
        if self.inputs is not None:
            return planned(simulation, self.inputs, {p: f"plan.inputs.{p}" for p in self.inputs})
        given = {path: getattr(self, key) for path, key in KEYS.items()}
        return planned(simulation, given, {path: f"plan.{key}" for path, key in KEYS.items()})

    @property
    def settings(self) -> dict[str, Any]:
        """Fields but for the box."""
        box = {"name", *settings(PlanOptions)}
        return {key: value for key, value in member_group(self).items() if key not in box}

    def plan(self, ranges: tuple[Range, ...]) -> "Plan":
        """The plan over these ranges."""
        return Plan(self, ranges)

    @required
    def size(self, inputs: int) -> int:
        """The number of designs of so many inputs."""
        raise NotImplementedError

    @required
    def designs(self, ranges: tuple[Range, ...], first: int, last: int) -> Array:
        """Designs first to last - 1 over the ranges, as :class:`Plan` has them."""
        raise NotImplementedError


@dataclass(frozen=True)
class Plan:
    """Designs 0 to ``count`` - 1 over some ranges; the same numbers on every machine."""

    options: PlanOptions
    ranges: tuple[Range, ...]

    @property
    def count(self) -> int:
        """The number of designs."""
        return self.options.size(len(self.ranges))

    def designs(self, first: int, last: int) -> Array:
        """Designs first to last - 1, shape (last - first, I): a column for each of I ranges.

        Memory is in proportion to the stretch, never to ``count``. Raises ValueError for a
        stretch that is not within the plan.
        """
        if not 0 <= first <= last <= self.count:
            raise ValueError(f"designs {first} to {last} of a plan of {self.count}")
        return self.options.designs(self.ranges, first, last)


def checked_inputs(given: Any) -> dict[str, Range | None]:
    """Ranges by path, or None for a range that is declared. Raises ParameterError."""
    if not isinstance(given, Mapping) or not given:
        allowed = "null, or ranges by path: {design.epsilon: [0.1, 0.3], robot.thickness_m: null}"
        raise ParameterError("plan.inputs", given, allowed)
    return {
        path: None if limits is None else checked_range(f"plan.inputs.{path}", limits)
        for path, limits in given.items()
    }


class RandomPlanOptions(PlanOptions):
    """Plans of a chosen number of designs, by a seed."""

    count: int = integer(4096, least=1, most=MOST_DESIGNS)
    seed: int = integer(0, least=0, most=LARGEST_SEED)

    def size(self, inputs: int) -> int:
        return self.count
