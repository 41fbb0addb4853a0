"""Options of the sampling plans."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any

from snapjump.checks import ParameterError, check_integer
from snapjump.plan.axes import Axis, checked_range, default_axes, planned
from snapjump.plan.base import Plan, Range
from snapjump.plan.grid import GridPlan
from snapjump.plan.latin_hypercube import LatinHypercubePlan
from snapjump.plan.sobol import SobolPlan

MOST_POINTS = 1000
MOST_DESIGNS = 2**30
MOST_OF_A_GRID = 2**40
LARGEST_SEED = 2**32 - 1

# What the four inputs are called where ``inputs`` is null.
KEYS = {axis.path: axis.column for axis in default_axes()}


@dataclass(frozen=True)
class PlanOptions:
    """The box that designs are taken from: [low, high] of each input, None for the declared one.

    ``inputs``: by path, any inputs in the order of their columns; None: the four, each of which
    has a key of its own.
    """

    inputs: Mapping[str, Range | None] | None = None
    delta_alpha_rad: Range | None = None
    epsilon: Range | None = None
    mass_bar: Range | None = None
    mu: Range | None = None

    def __post_init__(self) -> None:
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
            keys = {path: f"plan.inputs.{path}" for path in self.inputs}
            return planned(simulation, self.inputs, keys)
        given = {path: getattr(self, key) for path, key in KEYS.items()}
        return planned(simulation, given, {path: f"plan.{key}" for path, key in KEYS.items()})

    @property
    def settings(self) -> dict[str, Any]:
        """All but the box."""
        box = {field.name for field in fields(PlanOptions)}
        return {name: value for name, value in asdict(self).items() if name not in box}

    def member(self, ranges: tuple[Range, ...]) -> Plan:
        """The plan over these ranges."""
        raise NotImplementedError


def checked_inputs(given: Any) -> dict[str, Range | None]:
    """Ranges by path, or None for a range that is declared. Raises ParameterError."""
    if not isinstance(given, Mapping) or not given:
        allowed = "null, or ranges by path: {design.epsilon: [0.1, 0.3], robot.thickness_m: null}"
        raise ParameterError("plan.inputs", given, allowed)
    return {
        path: None if limits is None else checked_range(f"plan.inputs.{path}", limits)
        for path, limits in given.items()
    }


@dataclass(frozen=True)
class GridPlanOptions(PlanOptions):
    """Every combination of evenly spaced values; by default the paper's 15^4."""

    points: int = 15

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("plan.points", self.points, 2, MOST_POINTS)

    def member(self, ranges: tuple[Range, ...]) -> GridPlan:
        """The plan over these ranges. Raises ParameterError for too many designs."""
        plan = GridPlan(ranges, self.points)
        if plan.count > MOST_OF_A_GRID:
            allowed = f"fewer: {self.points}^{len(ranges)} designs are more than 2^40"
            raise ParameterError("plan.points", self.points, allowed)
        return plan


@dataclass(frozen=True)
class RandomPlanOptions(PlanOptions):
    """So many designs, by a seed."""

    count: int = 4096
    seed: int = 0

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("plan.count", self.count, 1, MOST_DESIGNS)
        check_integer("plan.seed", self.seed, 0, LARGEST_SEED)


class SobolPlanOptions(RandomPlanOptions):
    """Scrambled Sobol points; best a power of two of them."""

    def member(self, ranges: tuple[Range, ...]) -> SobolPlan:
        """The plan over these ranges."""
        return SobolPlan(ranges, self.count, self.seed)


class LatinHypercubePlanOptions(RandomPlanOptions):
    """Random points, one in each of as many equal intervals of every input."""

    def member(self, ranges: tuple[Range, ...]) -> LatinHypercubePlan:
        """The plan over these ranges."""
        return LatinHypercubePlan(ranges, self.count, self.seed)
