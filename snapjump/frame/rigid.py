"""A rigid frame: three coordinates (x, y, theta) of its centre of mass, contact at four corners.

The clamped end nodes of the beam belong to it, so that its mass matrix is diagonal.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import (
    acts,
    bounce_rate_squared,
    contact_weights,
    force_if_acting,
    has_contact,
    note_contact,
)
from snapjump.damping.base import mass_damping
from snapjump.discretization.base import (
    EndTangents,
    clamp_offset,
    node_dofs,
    turn_length,
)
from snapjump.frame.base import (
    FrameForces,
    add_frame_forces,
    condense_first,
    condense_last,
    corner_mass,
    corner_point,
    end_tangents,
    frame_dofs,
    frame_mass,
    limit_frame_step,
    place_ends,
)
from snapjump.frame.ends import release_first_node, release_last_node
from snapjump.frame.rigid_corners import add_corner_friction, corner_approach, corner_arm
from snapjump.frame.rigid_ends import add_border, condense_hinged_node, condense_turning_node
from snapjump.friction.base import has_friction
from snapjump.load.base import gravity
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, any_true, cos, maximum, minimum, sin, where


class RigidFrame(NamedTuple):
    """Half the width; heights of mounts, feet and top against the centre of mass (in L); mass
    and moment of inertia (in rho A L and rho A L^3)."""

    half_span: float
    mount_y: float
    foot_y: float
    top_y: float
    mass: float
    inertia: float


@frame_dofs.member(RigidFrame)
def _frame_dofs(frame: RigidFrame) -> int:
    return 3


@end_tangents.member(RigidFrame)
def _end_tangents(frame: RigidFrame, load: Any, angles: Any, state: Any, velocity: Any) -> Any:
    left = state[2] - angles.left
    right = state[2] + angles.right
    return EndTangents(
        cos(left),
        sin(left),
        velocity - angles.left_rate,
        cos(right),
        sin(right),
        velocity + angles.right_rate,
        0.0 * left,
        0.0 * left,
    )


@kernel
def first_arm(frame: Any, offset: Any, tangents: Any, turn: Any) -> Any:
    """Vector from the centre of mass to the first node."""
    c = cos(turn)
    s = sin(turn)
    return (
        -frame.mount_y * s - frame.half_span * c + offset * tangents.left_x,
        frame.mount_y * c - frame.half_span * s + offset * tangents.left_y,
    )


@kernel
def last_arm(frame: Any, offset: Any, tangents: Any, turn: Any) -> Any:
    """Vector from the centre of mass to the last node."""
    c = cos(turn)
    s = sin(turn)
    return (
        -frame.mount_y * s + frame.half_span * c - offset * tangents.right_x,
        frame.mount_y * c + frame.half_span * s - offset * tangents.right_y,
    )


@place_ends.member(RigidFrame)
def _place_ends(frame: RigidFrame, discretization: Any, angles: Any, state: Any) -> None:
    tangents = _end_tangents(frame, 0.0, angles, state, 0.0 * state[2])
    dofs = node_dofs(discretization)
    offset = clamp_offset(discretization)
    lx, ly = first_arm(frame, offset, tangents, state[2])
    rx, ry = last_arm(frame, offset, tangents, state[2])
    last = state.shape[0] - dofs
    state[3] = state[0] + lx
    state[4] = state[1] + ly
    state[last] = state[0] + rx
    state[last + 1] = state[1] + ry
    if dofs == 3:
        state[5] = turn_length(discretization) * (state[2] - angles.left)
        state[last + 2] = turn_length(discretization) * (state[2] + angles.right)


@condense_first.member(RigidFrame)
def _condense_first(
    frame: RigidFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    arm_x, arm_y = first_arm(frame, clamp_offset(discretization), tangents, state[2])
    if node_dofs(discretization) == 3:
        condense_turning_node(0, turn_length(discretization), arm_x, arm_y, system)
        for row in range(3, 6):
            bx, by, bt = system.band[0, row], system.band[1, row - 1], system.band[2, row - 2]
            add_border(bx, by, arm_x, arm_y, system.border, row)
            system.border[row, 2] += turn_length(discretization) * bt
        release_first_node(3, system.residual, system.band)
    else:
        condense_hinged_node(0, hinge, -1.0, arm_x, arm_y, system)
        for row in range(2, 6):
            bx, by = system.band[0, row], system.band[1, row - 1]
            add_border(bx, by, arm_x, arm_y, system.border, row)
        system.border[2, 2] -= hinge.stiffness * hinge.slope_x
        system.border[3, 2] -= hinge.stiffness * hinge.slope_y
        release_first_node(2, system.residual, system.band)


@condense_last.member(RigidFrame)
def _condense_last(
    frame: RigidFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    arm_x, arm_y = last_arm(frame, clamp_offset(discretization), tangents, state[2])
    band = system.band
    border = system.border
    dofs = node_dofs(discretization)
    last = (state.shape[0] - 3) // dofs - 1
    row = dofs * last
    if dofs == 3:
        condense_turning_node(row, turn_length(discretization), arm_x, arm_y, system)
        for k in range(1, 4):
            add_border(band[row - k, k], band[row - k, k + 1], arm_x, arm_y, border, row - k)
            border[row - k, 2] += turn_length(discretization) * band[row - k, k + 2]
    else:
        condense_hinged_node(row, hinge, 1.0, arm_x, arm_y, system)
        for k in range(1, 5):
            add_border(band[row - k, k], band[row - k, k + 1], arm_x, arm_y, border, row - k)
        border[row - 2, 2] += hinge.stiffness * hinge.slope_x
        border[row - 1, 2] += hinge.stiffness * hinge.slope_y
    release_last_node(dofs, system.residual, band, last)


@add_frame_forces.member(RigidFrame)
def _add_frame_forces(frame: RigidFrame, model: Any, motion: Any, work: Any) -> Any:
    state = work.state
    residual = work.system.frame_residual
    square = work.system.square
    rate = motion.rate_factor
    drag = mass_damping(model.damping)
    largest = 0.0 * rate
    for k in range(3):
        mass = frame.inertia if k == 2 else frame.mass
        velocity = (state[k] - work.origin[k]) * rate
        inertial = mass * (velocity - work.drift[k]) * motion.inertia_rate
        residual[k] += inertial + mass * drag * velocity
        square[k, k] += mass * (motion.inertia_rate + drag) * rate
        largest = maximum(largest, absolute(inertial))
    weight = frame.mass * gravity(model.load)
    residual[1] += weight
    largest = maximum(largest, 0.0 * rate + weight)
    # Statics leaves x undetermined: a spring that ends up without force holds it.
    residual[0] += motion.anchor * state[0]
    square[0, 0] += motion.anchor

    smallest = 0.0 * rate + 1.0e30
    fastest = 0.0 * rate
    if has_contact(model.contact):
        contact = model.contact
        _, weight = contact_weights(contact)
        c = cos(state[2])
        s = sin(state[2])
        for corner in range(4):
            rx, ry = corner_arm(frame, corner, c, s)
            gap = state[1] + ry
            smallest = minimum(smallest, gap)
            effective = 1.0 / (1.0 / frame.mass + rx * rx / frame.inertia)
            approach = corner_approach(frame, motion, work, corner, rx, effective)
            near = acts(contact, gap, approach)
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
                bounce = bounce_rate_squared(contact, stiffness, effective, approach.speed)
                fastest = maximum(fastest, bounce)
                if has_friction(model.friction):
                    add_corner_friction(
                        model, motion, work, corner, frame, rx, ry, near, force, stiffness
                    )
            note_contact(contact, work, corner, near)
    return FrameForces(largest, smallest, fastest)


@limit_frame_step.member(RigidFrame)
def _limit_frame_step(frame: RigidFrame, state: Any, drop: Any, fraction: Any) -> Any:
    c = cos(state[2])
    s = sin(state[2])
    share = 1.0 + 0.0 * state[0]
    for corner in range(4):
        rx, ry = corner_arm(frame, corner, c, s)
        gap = state[1] + ry
        # The second-order term bounds the corner's fall along its arc.
        fall = drop[1] + rx * drop[2] + 0.5 * absolute(ry) * drop[2] * drop[2]
        allowed = (1.0 - fraction) * gap
        share = minimum(share, where(fall > allowed, allowed / fall, 1.0))
    return share


@corner_point.member(RigidFrame)
def _corner_point(frame: RigidFrame, corner: Any, state: Any, velocity: Any) -> Any:
    rx, ry = corner_arm(frame, corner, cos(state[2]), sin(state[2]))
    vx = velocity[0] - ry * velocity[2]
    return state[0] + rx, state[1] + ry, vx, velocity[1] + rx * velocity[2]


@corner_mass.member(RigidFrame)
def _corner_mass(frame: RigidFrame, corner: Any, state: Any) -> Any:
    rx, _ = corner_arm(frame, corner, cos(state[2]), sin(state[2]))
    return 1.0 / (1.0 / frame.mass + rx * rx / frame.inertia)


@frame_mass.member(RigidFrame)
def _frame_mass(frame: RigidFrame, coordinate: Any) -> Any:
    return where(coordinate == 2, frame.inertia, frame.mass)
