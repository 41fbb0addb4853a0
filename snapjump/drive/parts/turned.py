"""Angles of both clamps from the left one's turn."""

from typing import Any

from snapjump.drive.base import ClampAngles
from snapjump.number.dispatch import kernel
from snapjump.number.functions import where


@kernel
def turned_to(clamp: Any, turned: Any, turning: Any) -> Any:
    """The :class:`~snapjump.drive.base.ClampAngles` when the left clamp would be at an angle (rad)
    and turn at a rate (rad/T), if none stopped."""
    stopped = turned > clamp.end
    left = where(stopped, clamp.end, turned)
    rate = where(stopped, 0.0, turning)
    right = left - clamp.delta_alpha
    right_rate = rate
    if clamp.has_two_rates():
        share = clamp.right_over_left()
        right = right + (share - 1.0) * (left - clamp.start)
        right_rate = rate * share
    return ClampAngles(left, right, rate, right_rate, 0.0, 0.0)


def time_turned(clamp: Any) -> Any:
    """Time (T) since the leading clamp was flat, at a march's beginning; of one or of many."""
    ahead = 0.5 * (abs(clamp.delta_alpha) - clamp.delta_alpha)
    return (clamp.start + ahead) / clamp.rate
