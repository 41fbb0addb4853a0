"""Random points of which every axis has exactly one in each of ``count`` equal intervals."""

import numpy as np

from snapjump.arrays import Array
from snapjump.plan.base import RandomPlanOptions, stretched
from snapjump.plan.parts.axes import Range
from snapjump.plan.parts.shuffle import keyed, shuffled

FIRST_JITTER = 1000  # streams of random bits beyond those that shuffle
MANTISSA_BITS = 53


class LatinHypercube(RandomPlanOptions):
    """Random points, one in each of as many equal intervals of every input.
    The order of the intervals is computed point by point."""

    def designs(self, ranges: tuple[Range, ...], first: int, last: int) -> Array:
        numbers = np.arange(first, last, dtype=np.uint64)
        unit = np.empty((last - first, len(ranges)))
        for axis in range(len(ranges)):
            interval = shuffled(numbers, self.count, self.seed, axis)
            bits = keyed(self.seed, FIRST_JITTER + axis, numbers)
            within = (bits >> np.uint64(64 - MANTISSA_BITS)) * 2.0**-MANTISSA_BITS
            unit[:, axis] = (interval + within) / self.count
        return stretched(unit, ranges)
