"""Every combination of evenly spaced values."""

from dataclasses import dataclass

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.fields import integer
from snapjump.plan.base import Array, PlanOptions, check_stretch
from snapjump.plan.parts.axes import Range

MOST_POINTS = 1000
MOST_OF_A_GRID = 2**40


@dataclass(frozen=True)
class GridPlan:
    """``points`` values on each axis, its ends among them; the last axis runs fastest."""

    ranges: tuple[Range, ...]
    points: int

    @property
    def count(self) -> int:
        return int(self.points ** len(self.ranges))

    def designs(self, first: int, last: int) -> Array:
        check_stretch(first, last, self.count)
        places = np.unravel_index(np.arange(first, last), (self.points,) * len(self.ranges))
        axes = [np.linspace(low, high, self.points) for low, high in self.ranges]
        return np.stack([axis[place] for axis, place in zip(axes, places, strict=True)], axis=1)


class Grid(PlanOptions):
    """Every combination of evenly spaced values; by default the paper's 15^4."""

    points: int = integer(15, least=2, most=MOST_POINTS)

    def plan(self, ranges: tuple[Range, ...]) -> GridPlan:
        """The plan over these ranges. Raises ParameterError for too many designs."""
        plan = GridPlan(ranges, self.points)
        if plan.count > MOST_OF_A_GRID:
            allowed = f"fewer: {self.points}^{len(ranges)} designs are more than 2^40"
            raise ParameterError("plan.points", self.points, allowed)
        return plan
