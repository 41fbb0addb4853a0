"""An ending at a fixed time."""

from typing import Any, NamedTuple

from snapjump.ending.base import judge, leniency, time_limit
from snapjump.engine.clock import TIME
from snapjump.engine.status import OK, RUNNING
from snapjump.number.functions import where


class TimedEnding(NamedTuple):
    """The last moment (T)."""

    duration: float


@time_limit.member(TimedEnding)
def _time_limit(ending: TimedEnding) -> Any:
    return ending.duration


@leniency.member(TimedEnding)
def _leniency(ending: TimedEnding, model: Any, work: Any) -> float:
    return 1.0


@judge.member(TimedEnding)
def _judge(ending: TimedEnding, model: Any, masses: Any, work: Any, ended: Any) -> Any:
    over = work.clock[TIME] >= ending.duration * (1.0 - 1e-12)
    return where(over, 1.0 * OK, 1.0 * RUNNING)
