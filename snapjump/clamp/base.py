"""How the clamps are rotated: the contract that every rotation programme fulfils."""

from typing import Any, NamedTuple

from snapjump.number.dispatch import family_function


class ClampAngles(NamedTuple):
    """Angles (rad) of the left and right clamp against the frame, and their rates (rad/T).

    The end tangents turn downwards: -left at s = 0, +right at s = L.
    """

    left: Any
    right: Any
    left_rate: Any
    right_rate: Any


@family_function
def clamp_angles(clamp: Any, time: Any) -> Any:
    """The :class:`ClampAngles` at a time (in T)."""
