"""Corners of the rigid frame: where they are, how the ground pushes and drags them."""

from typing import Any

from snapjump.contact.base import Approach, force_if_acting, note_contact, pressing_force
from snapjump.frame.base import FrameForces
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true, cos, maximum, minimum, sin, where


@kernel
def corner_arm(frame: Any, corner: Any, c: Any, s: Any) -> Any:
    """Vector from the centre of mass to a corner: left foot, left top, right top, right foot."""
    x = -frame.half_span if corner < 2 else frame.half_span
    y = frame.foot_y if corner == 0 or corner == 3 else frame.top_y
    return c * x - s * y, s * x + c * y


@kernel
def corner_approach(
    frame: Any, motion: Any, work: Any, corner: Any, rx: Any, effective_mass: Any
) -> Approach:
    """How a corner at ``rx`` from the centre of mass comes near the ground within a stage."""
    rate = motion.rate_factor
    start = work.start
    begun = work.velocity[0]
    sx, sy = corner_arm(frame, corner, cos(start[2]), sin(start[2]))
    return Approach(
        (work.state[1] - work.origin[1] + rx * (work.state[2] - work.origin[2])) * rate,
        rate,
        start[1] + sy,
        begun[1] + sx * begun[2],
        effective_mass * rate * motion.inertia_rate,
    )


@kernel
def add_lagged_corner_friction(
    model: Any, motion: Any, work: Any, corner: Any, frame: Any, ry: Any, approach: Approach
) -> None:
    """Add friction of the step's beginning, also where the corner has lifted off since."""
    residual = work.system.frame_residual
    zero = 0.0 * approach.rate
    begun = approach.begun
    before = Approach(approach.begun_speed, zero, begun, approach.begun_speed, zero)
    if any_true(model.contact.active(begun, before)):
        _, normal, _ = force_if_acting(model.contact, begun, before)
        start = work.start[2]
        _, sy = corner_arm(frame, corner, cos(start), sin(start))
        velocity = work.velocity[0, 0] - sy * work.velocity[0, 2]
        ratio = model.friction.ratio(velocity)
        drag = ratio * normal * model.ground.corner_share
        residual[0] += drag
        residual[2] -= ry * drag


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
    rate = motion.rate_factor
    turn = (work.state[2] - work.origin[2]) * rate
    velocity = (work.state[0] - work.origin[0]) * rate - ry * turn
    previous = work.slip[corner]
    ratio = friction.ratio(velocity)
    slope = friction.slope(velocity, previous)
    work.slip[corner] = where(near, velocity, previous)
    normal = pressing_force(model.contact, work, corner, force)
    # A constraint's stiffness is no derivative of the force that friction sees.
    yielding = 0.0 if model.contact.is_impulsive() else 1.0
    drag = ratio * normal
    residual[0] += drag
    residual[2] -= ry * drag
    along_x = normal * slope * rate
    along_y = -ratio * stiffness * yielding
    along_turn = normal * slope * (-ry * rate - rx * turn) + along_y * rx
    square[0, 0] += along_x
    square[0, 1] += along_y
    square[0, 2] += along_turn
    square[2, 0] -= ry * along_x
    square[2, 1] -= ry * along_y
    square[2, 2] -= ry * along_turn + rx * drag


@kernel
def add_corner_contacts(
    frame: Any, model: Any, motion: Any, work: Any, figures: FrameForces
) -> FrameForces:
    """Add contact and friction at all four corners; returns the figures with theirs."""
    contact = model.contact
    state = work.state
    residual = work.system.frame_residual
    square = work.system.square
    largest = figures.largest_force
    smallest = figures.smallest_gap
    fastest = figures.contact_rate_squared
    weight = model.ground.corner_share
    c = cos(state[2])
    s = sin(state[2])
    for corner in range(4):
        rx, ry = corner_arm(frame, corner, c, s)
        gap = state[1] + ry
        smallest = minimum(smallest, gap)
        effective = 1.0 / (1.0 / frame.mass + rx * rx / frame.inertia)
        approach = corner_approach(frame, motion, work, corner, rx, effective)
        near = contact.active(gap, approach)
        if model.friction.exists() and model.friction.is_lagged():
            add_lagged_corner_friction(model, motion, work, corner, frame, ry, approach)
        if any_true(near):
            _, force, stiffness = force_if_acting(contact, gap, approach)
            force = force * weight
            stiffness = stiffness * weight
            largest = maximum(largest, force)
            residual[1] -= force
            residual[2] -= force * rx
            square[1, 1] += stiffness
            square[1, 2] += stiffness * rx
            square[2, 1] += stiffness * rx
            square[2, 2] += stiffness * rx * rx + force * ry
            bounce = contact.bounce_rate_squared(stiffness, effective, approach.speed)
            fastest = maximum(fastest, bounce)
            if model.friction.exists() and not model.friction.is_lagged():
                add_corner_friction(
                    model, motion, work, corner, frame, rx, ry, near, force, stiffness
                )
        note_contact(contact, work, corner, near)
    return FrameForces(largest, smallest, fastest)
