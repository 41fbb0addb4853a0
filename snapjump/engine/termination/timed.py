"""Termination at a fixed time."""

from typing import Any, NamedTuple

from snapjump.engine.clock import TIME
from snapjump.engine.status import OK, RUNNING
from snapjump.engine.termination.base import Termination
from snapjump.number.functions import where


@Termination.member
class TimedTermination(NamedTuple):
    """The last moment (T)."""

    duration: float

    def time_limit(self, model: Any) -> Any:
        return self.duration

    def tolerance_factor(self, model: Any, work: Any) -> float:
        return 1.0

    def terminate(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        over = work.clock[TIME] >= self.duration * (1.0 - 1e-12)
        return where(over, 1.0 * OK, 1.0 * RUNNING)
