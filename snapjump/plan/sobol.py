"""Scrambled Sobol points: fill the box evenly, whatever their number."""

import warnings
from dataclasses import dataclass

from snapjump.plan.base import Array, RandomPlanOptions, check_stretch, stretched
from snapjump.plan.parts.axes import Range


@dataclass(frozen=True)
class SobolPlan:
    """The first ``count`` points of the sequence that ``seed`` scrambles."""

    ranges: tuple[Range, ...]
    count: int
    seed: int

    def designs(self, first: int, last: int) -> Array:
        from scipy.stats.qmc import Sobol

        check_stretch(first, last, self.count)
        sequence = Sobol(d=len(self.ranges), scramble=True, rng=self.seed)
        if first > 0:
            sequence.fast_forward(first)
        with warnings.catch_warnings():
            # That a stretch is best a power of two long is said of the whole, not of stretches.
            warnings.simplefilter("ignore", UserWarning)
            return stretched(sequence.random(last - first), self.ranges)


class Sobol(RandomPlanOptions):
    """Scrambled Sobol points; best a power of two of them."""

    def plan(self, ranges: tuple[Range, ...]) -> SobolPlan:
        """The plan over these ranges."""
        return SobolPlan(ranges, self.count, self.seed)
