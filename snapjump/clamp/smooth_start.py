"""Clamps that reach their rate smoothly: alpha = rate (t - tau (1 - exp(-t / tau)))."""

from typing import Any, NamedTuple

from snapjump.clamp.base import ClampAngles, clamp_angles
from snapjump.number.exponentials import exp
from snapjump.number.functions import where


class SmoothStart(NamedTuple):
    """Left angle at time 0 and at the end (rad), rate (rad/T), lag of the right, and tau (T)."""

    start: float
    end: float
    rate: float
    delta_alpha: float
    rise_time: float


@clamp_angles.member(SmoothStart)
def _angles(clamp: SmoothStart, time: Any) -> Any:
    missing = 1.0 - exp(-time / clamp.rise_time)
    turned = clamp.start + clamp.rate * (time - clamp.rise_time * missing)
    stopped = turned > clamp.end
    left = where(stopped, clamp.end, turned)
    rate = where(stopped, 0.0, clamp.rate * missing)
    return ClampAngles(left, left - clamp.delta_alpha, rate, rate)
