"""Termination of one mass on the ground, at a fixed time: how closely it is followed until then."""

from typing import Any, NamedTuple

from snapjump.engine.clock import SIZE, STEP, TIME
from snapjump.engine.status import OK, RUNNING
from snapjump.engine.termination.base import Termination
from snapjump.number.functions import absolute, maximum, minimum, where

ROUNDING = 2.0**-50  # of a coordinate: what Newton's method cannot go below


@Termination.member
class OneMassTermination(NamedTuple):
    """The last moment (T), and the speed (L/T) that is too small to matter.

    A law that keeps gaps open pushes as their logarithm says: errors count as shares of the gap at
    that end of a step where it is smaller.
    """

    duration: float
    negligible_speed: float

    def time_limit(self, model: Any) -> Any:
        return self.duration

    def tolerance_factor(self, model: Any, work: Any) -> Any:
        factor = 1.0 + 0.0 * work.clock[STEP]
        if model.contact.keeps_open():
            gap = minimum(work.start[1], work.state[1])
            factor = minimum(factor, gap / model.contact.reach())
        return factor

    def newton_tolerance(self, work: Any, tolerance: Any) -> Any:
        clock = work.clock
        place = maximum(absolute(work.state[0]), absolute(work.state[1]))
        unseen = maximum(self.negligible_speed * clock[STEP], ROUNDING * place)
        unseen = minimum(unseen, tolerance + 0.0 * unseen)
        # How corrections shrink tells nothing where the slope of friction changes between them:
        # each must be as small as that, which this makes of the product that is judged.
        last = maximum(clock[SIZE], unseen)
        return unseen * unseen / last

    def terminate(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        over = work.clock[TIME] >= self.duration * (1.0 - 1e-12)
        return where(over, 1.0 * OK, 1.0 * RUNNING)
