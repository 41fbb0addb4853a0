"""Scrambled Sobol points: fill the box evenly, whatever their number."""

import warnings

from snapjump.arrays import Array
from snapjump.plan.base import RandomPlanOptions, stretched
from snapjump.plan.parts.axes import Range


class Sobol(RandomPlanOptions):
    """Scrambled Sobol points; best a power of two of them."""

    def designs(self, ranges: tuple[Range, ...], first: int, last: int) -> Array:
        from scipy.stats.qmc import Sobol as Sequence

        sequence = Sequence(d=len(ranges), scramble=True, rng=self.seed)
        if first > 0:
            sequence.fast_forward(first)
        with warnings.catch_warnings():
            # That a stretch is best a power of two long is said of the whole, not of stretches.
            warnings.simplefilter("ignore", UserWarning)
            return stretched(sequence.random(last - first), ranges)
