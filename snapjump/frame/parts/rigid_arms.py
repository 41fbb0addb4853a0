"""Places on a rigid frame, from its centre of mass."""

from typing import Any

from snapjump.frame.parts.ends import Arm
from snapjump.number.dispatch import kernel
from snapjump.number.trigonometry import cos, sin


@kernel
def corner_arm(frame: Any, corner: Any, c: Any, s: Any) -> Any:
    """Vector from the centre of mass to a corner: left foot, left top, right top, right foot."""
    x = (-frame.half_span if corner < 2 else frame.half_span) - frame.offset
    y = frame.foot_y if corner == 0 or corner == 3 else frame.top_y
    return c * x - s * y, s * x + c * y


@kernel
def first_arm(frame: Any, offset: Any, tangents: Any, turn: Any) -> Arm:
    """Vector from the centre of mass to the first node."""
    c = cos(turn)
    s = sin(turn)
    span = frame.half_span + frame.offset
    return Arm(
        -frame.mount_y * s - span * c + offset * tangents.left_x,
        frame.mount_y * c - span * s + offset * tangents.left_y,
    )


@kernel
def last_arm(frame: Any, offset: Any, tangents: Any, turn: Any) -> Arm:
    """Vector from the centre of mass to the last node."""
    c = cos(turn)
    s = sin(turn)
    span = frame.half_span - frame.offset
    return Arm(
        -frame.mount_y * s + span * c - offset * tangents.right_x,
        frame.mount_y * c + span * s - offset * tangents.right_y,
    )
