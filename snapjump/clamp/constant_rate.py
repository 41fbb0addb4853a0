"""Clamps turned at a constant rate from a given angle up to a final one."""

from typing import Any, NamedTuple

from snapjump.clamp.base import ClampAngles, clamp_angles
from snapjump.number.functions import where


class ConstantRate(NamedTuple):
    """Left angle at time 0 and at the end (rad), its rate (rad/T), and how far the right lags."""

    start: float
    end: float
    rate: float
    delta_alpha: float


@clamp_angles.member(ConstantRate)
def _angles(clamp: ConstantRate, time: Any) -> Any:
    turned = clamp.start + clamp.rate * time
    stopped = turned > clamp.end
    left = where(stopped, clamp.end, turned)
    rate = where(stopped, 0.0, clamp.rate + 0.0 * time)
    return ClampAngles(left, left - clamp.delta_alpha, rate, rate)
