"""An ending at a fixed time."""

from typing import Any, NamedTuple

from snapjump.engine.clock import TIME
from snapjump.engine.status import OK, RUNNING
from snapjump.engine.termination.base import Ending
from snapjump.number.functions import where


@Ending.member
class TimedEnding(NamedTuple):
    """The last moment (T)."""

    duration: float

    def time_limit(self, model: Any) -> Any:
        return self.duration

    def leniency(self, model: Any, work: Any) -> float:
        return 1.0

    def judge(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        over = work.clock[TIME] >= self.duration * (1.0 - 1e-12)
        return where(over, 1.0 * OK, 1.0 * RUNNING)
