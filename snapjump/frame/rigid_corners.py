"""Corners of the rigid frame: where they are, and how friction drags them."""

from typing import Any

from snapjump.contact.base import contact_force, contact_reach, contact_weights
from snapjump.friction.base import is_lagged, slip
from snapjump.number.dispatch import kernel
from snapjump.number.functions import cos, sin, where


@kernel
def corner_arm(frame: Any, corner: Any, c: Any, s: Any) -> Any:
    """Vector from the centre of mass to a corner: left foot, left top, right top, right foot."""
    x = -frame.half_span if corner < 2 else frame.half_span
    y = frame.foot_y if corner == 0 or corner == 3 else frame.top_y
    return c * x - s * y, s * x + c * y


@kernel
def add_corner_friction(
    model: Any,
    motion: Any,
    work: Any,
    corner: Any,
    frame: Any,
    rx: Any,
    ry: Any,
    near: Any,
    force: Any,
    stiffness: Any,
) -> None:
    """Add friction at one corner, with its full, unsymmetric derivative."""
    residual = work.system.frame_residual
    square = work.system.square
    friction = model.friction
    if is_lagged(friction):
        start = work.start
        begun = work.velocity[0]
        _, sy = corner_arm(frame, corner, cos(start[2]), sin(start[2]))
        gap = start[1] + sy
        was_near = gap < contact_reach(model.contact)
        normal, _ = contact_force(model.contact, where(was_near, gap, contact_reach(model.contact)))
        velocity = begun[0] - sy * begun[2]
        ratio, _ = slip(friction, velocity, 0.0 * velocity)
        _, weight = contact_weights(model.contact)
        drag = ratio * normal * weight
        residual[0] += drag
        residual[2] -= ry * drag
    else:
        rate = motion.rate_factor
        turn = (work.state[2] - work.origin[2]) * rate
        velocity = (work.state[0] - work.origin[0]) * rate - ry * turn
        previous = work.slip[corner]
        ratio, slope = slip(friction, velocity, previous)
        work.slip[corner] = where(near, velocity, previous)
        drag = ratio * force
        residual[0] += drag
        residual[2] -= ry * drag
        along_x = force * slope * rate
        along_y = -ratio * stiffness
        along_turn = force * slope * (-ry * rate - rx * turn) - ratio * stiffness * rx
        square[0, 0] += along_x
        square[0, 1] += along_y
        square[0, 2] += along_turn
        square[2, 0] -= ry * along_x
        square[2, 1] -= ry * along_y
        square[2, 2] -= ry * along_turn + rx * drag
