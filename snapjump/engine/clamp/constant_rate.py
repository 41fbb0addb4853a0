"""Clamps turned at a constant rate from a given angle up to a final one."""

from typing import Any, NamedTuple

from snapjump.engine.clamp.base import ClampAngles, ClampProgramme
from snapjump.number.functions import where


def time_turned(clamp: Any) -> Any:
    """Time (T) since the leading clamp was flat, at a march's beginning; of one or of many."""
    ahead = 0.5 * (abs(clamp.delta_alpha) - clamp.delta_alpha)
    return (clamp.start + ahead) / clamp.rate


@ClampProgramme.member
class ConstantRate(NamedTuple):
    """Left angle at time 0 and at the end (rad), its rate (rad/T), and how far the right lags."""

    start: float
    end: float
    rate: float
    delta_alpha: float

    def angles(self, time: Any) -> Any:
        turned = self.start + self.rate * time
        stopped = turned > self.end
        left = where(stopped, self.end, turned)
        rate = where(stopped, 0.0, self.rate + 0.0 * time)
        return ClampAngles(left, left - self.delta_alpha, rate, rate)
