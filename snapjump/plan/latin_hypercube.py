"""Random points of which every axis has exactly one in each of ``count`` equal intervals."""

from dataclasses import dataclass

import numpy as np

from snapjump.plan.base import Array, RandomPlanOptions, check_stretch, stretched
from snapjump.plan.parts.axes import Range
from snapjump.plan.parts.shuffle import keyed, shuffled

FIRST_JITTER = 1000  # streams of random bits beyond those that shuffle
MANTISSA_BITS = 53


@dataclass(frozen=True)
class LatinHypercubePlan:
    """``count`` points by ``seed``; the order of the intervals is computed point by point."""

    ranges: tuple[Range, ...]
    count: int
    seed: int

    def designs(self, first: int, last: int) -> Array:
        check_stretch(first, last, self.count)
        numbers = np.arange(first, last, dtype=np.uint64)
        unit = np.empty((last - first, len(self.ranges)))
        for axis in range(len(self.ranges)):
            interval = shuffled(numbers, self.count, self.seed, axis)
            bits = keyed(self.seed, FIRST_JITTER + axis, numbers)
            within = (bits >> np.uint64(64 - MANTISSA_BITS)) * 2.0**-MANTISSA_BITS
            unit[:, axis] = (interval + within) / self.count
        return stretched(unit, self.ranges)


class LatinHypercube(RandomPlanOptions):
    """Random points, one in each of as many equal intervals of every input."""

    def plan(self, ranges: tuple[Range, ...]) -> LatinHypercubePlan:
        """The plan over these ranges."""
        return LatinHypercubePlan(ranges, self.count, self.seed)
