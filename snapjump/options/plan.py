"""Options of the sampling plans."""

from dataclasses import dataclass
from typing import Any

from snapjump.checks import ParameterError, check_integer, is_finite_number
from snapjump.plan.base import AXES, Range
from snapjump.plan.grid import GridPlan
from snapjump.plan.latin_hypercube import LatinHypercubePlan
from snapjump.plan.sobol import SobolPlan

# What a design and an environment may be.
WIDEST = {
    "delta_alpha_rad": (-0.5, 0.5),
    "epsilon": (1e-6, 0.4),
    "mass_bar": (1e-6, 1e6),
    "mu": (0.0, 1e6),
}
MOST_POINTS = 1000
MOST_DESIGNS = 2**30
LARGEST_SEED = 2**32 - 1


@dataclass(frozen=True)
class PlanRanges:
    """The box that designs are taken from: [low, high] of each input, by default the paper's."""

    delta_alpha_rad: Range = (0.01, 0.19)
    epsilon: Range = (0.1, 0.3)
    mass_bar: Range = (0.3, 2.0)
    mu: Range = (0.1, 0.6)

    def __post_init__(self) -> None:
        for axis in AXES:
            object.__setattr__(self, axis, checked_range(axis, getattr(self, axis)))

    @property
    def ranges(self) -> tuple[Range, ...]:
        """In the order of the axes."""
        return tuple(getattr(self, axis) for axis in AXES)


def checked_range(axis: str, given: Any) -> Range:
    """Low and high as floats. Raises ParameterError."""
    low, high = WIDEST[axis]
    allowed = f"two numbers [low, high], low below high, within [{low:g}, {high:g}]"
    if not isinstance(given, (list, tuple)) or len(given) != 2:
        raise ParameterError(f"plan.{axis}", given, allowed)
    if not all(is_finite_number(value) for value in given):
        raise ParameterError(f"plan.{axis}", given, allowed)
    if not low <= given[0] < given[1] <= high:
        raise ParameterError(f"plan.{axis}", given, allowed)
    return float(given[0]), float(given[1])


@dataclass(frozen=True)
class GridPlanOptions(PlanRanges):
    """Every combination of evenly spaced values; by default the paper's 15^4."""

    points: int = 15

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("plan.points", self.points, 2, MOST_POINTS)

    def member(self) -> GridPlan:
        """The plan."""
        return GridPlan(self.ranges, self.points)


@dataclass(frozen=True)
class SobolPlanOptions(PlanRanges):
    """Scrambled Sobol points; best a power of two of them."""

    count: int = 4096
    seed: int = 0

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("plan.count", self.count, 1, MOST_DESIGNS)
        check_integer("plan.seed", self.seed, 0, LARGEST_SEED)

    def member(self) -> SobolPlan:
        """The plan."""
        return SobolPlan(self.ranges, self.count, self.seed)


@dataclass(frozen=True)
class LatinHypercubePlanOptions(PlanRanges):
    """Random points, one in each of as many equal intervals of every input."""

    count: int = 4096
    seed: int = 0

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("plan.count", self.count, 1, MOST_DESIGNS)
        check_integer("plan.seed", self.seed, 0, LARGEST_SEED)

    def member(self) -> LatinHypercubePlan:
        """The plan."""
        return LatinHypercubePlan(self.ranges, self.count, self.seed)


PLANS = {
    "grid": GridPlanOptions,
    "sobol": SobolPlanOptions,
    "latin_hypercube": LatinHypercubePlanOptions,
}
