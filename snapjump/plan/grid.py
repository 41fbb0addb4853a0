"""Every combination of evenly spaced values."""

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.declare.fields import integer
from snapjump.plan.base import Plan, PlanOptions
from snapjump.plan.parts.axes import Range

MOST_POINTS = 1000
MOST_OF_A_GRID = 2**40


class Grid(PlanOptions):
    """Every combination of evenly spaced values; by default the paper's 15^4.
    The ends of each range are among its values; the last input runs fastest."""

    points: int = integer(15, least=2, most=MOST_POINTS)

    def plan(self, ranges: tuple[Range, ...]) -> Plan:
        """The plan over these ranges. Raises ParameterError for too many designs."""
        if self.size(len(ranges)) > MOST_OF_A_GRID:
            allowed = f"fewer: {self.points}^{len(ranges)} designs are more than 2^40"
            raise ParameterError("plan.points", self.points, allowed)
        return super().plan(ranges)

    def size(self, inputs: int) -> int:
        return int(self.points**inputs)

    def designs(self, ranges: tuple[Range, ...], first: int, last: int) -> Array:
        places = np.unravel_index(np.arange(first, last), (self.points,) * len(ranges))
        axes = [np.linspace(low, high, self.points) for low, high in ranges]
        return np.stack([axis[place] for axis, place in zip(axes, places, strict=True)], axis=1)
