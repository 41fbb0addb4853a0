"""Clamps that reach their rate smoothly: alpha = rate (t - tau (1 - exp(-t / tau)))."""

from typing import Any, NamedTuple

from snapjump.engine.clamp.base import ClampAngles, ClampProgramme
from snapjump.number.exponentials import exp
from snapjump.number.functions import where


@ClampProgramme.member
class SmoothStart(NamedTuple):
    """Left angle at time 0 and at the end (rad), rate (rad/T), mismatch, and tau (T)."""

    start: float
    end: float
    rate: float
    delta_alpha: float
    rise_time: float

    def angles(self, time: Any) -> Any:
        missing = 1.0 - exp(-time / self.rise_time)
        turned = self.start + self.rate * (time - self.rise_time * missing)
        stopped = turned > self.end
        left = where(stopped, self.end, turned)
        rate = where(stopped, 0.0, self.rate * missing)
        return ClampAngles(left, left - self.delta_alpha, rate, rate)
