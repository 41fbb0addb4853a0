"""A rigid frame: three coordinates (x, y, theta) of its centre of mass, contact at four corners.

The clamped end nodes of the beam belong to it, so that its mass matrix is diagonal.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import (
    contact_weights,
    has_contact,
)
from snapjump.damping.base import mass_damping
from snapjump.discretization.base import (
    EndTangents,
    clamp_offset,
    node_dofs,
    turn_length,
)
from snapjump.frame.base import (
    FrameBox,
    FrameForces,
    Turning,
    add_frame_forces,
    border_width,
    condense_first,
    condense_last,
    contact_point,
    contact_points,
    corner_point,
    end_tangents,
    frame_box,
    frame_dissipation,
    frame_dofs,
    frame_energy,
    frame_mass,
    frame_moments,
    limit_frame_step,
    mount_turning,
    place_ends,
    point_mass,
    point_weight,
    rest_frame,
    slide_frame,
    solve_frame,
)
from snapjump.frame.ends import move_first, move_last
from snapjump.frame.rigid_corners import add_corner_contacts, corner_arm
from snapjump.linear_solver import banded
from snapjump.load.base import gravity
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, cos, maximum, minimum, sin, where

LIFTED = 0.05  # of the anchor's stiffness, against rise and turn


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
def _frame_dofs(frame: RigidFrame, mesh: Any) -> int:
    return 3


@border_width.member(RigidFrame)
def _border_width(frame: RigidFrame) -> int:
    return 3


@mount_turning.member(RigidFrame)
def _mount_turning(frame: RigidFrame, mesh: Any, state: Any, vector: Any) -> Turning:
    return Turning(vector[2], vector[2])


@end_tangents.member(RigidFrame)
def _end_tangents(
    frame: RigidFrame, mesh: Any, load: Any, angles: Any, state: Any, turning: Turning
) -> Any:
    left = state[2] - angles.left
    right = state[2] + angles.right
    return EndTangents(
        cos(left),
        sin(left),
        turning.left - angles.left_rate,
        cos(right),
        sin(right),
        turning.right + angles.right_rate,
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
def _place_ends(frame: RigidFrame, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
    still = Turning(0.0 * state[2], 0.0 * state[2])
    tangents = _end_tangents(frame, mesh, 0.0, angles, state, still)
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
    frame: RigidFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    arm_x, arm_y = first_arm(frame, clamp_offset(discretization), tangents, state[2])
    move_first(discretization, hinge, arm_x, arm_y, system.frame_residual, system)


@condense_last.member(RigidFrame)
def _condense_last(
    frame: RigidFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    arm_x, arm_y = last_arm(frame, clamp_offset(discretization), tangents, state[2])
    last = (state.shape[0] - 3) // node_dofs(discretization) - 1
    move_last(discretization, last, hinge, arm_x, arm_y, system.frame_residual, system, 0)


@kernel
def clear(residual: Any, square: Any, zero: Any) -> None:
    """Zero the frame's own block and residual."""
    for k in range(3):
        residual[k] = zero
        for m in range(3):
            square[k, m] = zero


@add_frame_forces.member(RigidFrame)
def _add_frame_forces(frame: RigidFrame, model: Any, motion: Any, work: Any) -> Any:
    state = work.state
    residual = work.system.frame_residual
    square = work.system.square
    rate = motion.rate_factor
    drag = mass_damping(model.damping)
    largest = 0.0 * rate
    clear(residual, square, largest)
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
    # Feet that an iterate lifts off the ground have no stiffness: this lets the weight bring them
    # back, and leaves the equilibrium where it is.
    square[1, 1] += LIFTED * motion.anchor
    square[2, 2] += LIFTED * motion.anchor

    figures = FrameForces(largest, 0.0 * rate + 1.0e30, 0.0 * rate)
    if has_contact(model.contact):
        figures = add_corner_contacts(frame, model, motion, work, figures)
    return figures


@limit_frame_step.member(RigidFrame)
def _limit_frame_step(frame: RigidFrame, mesh: Any, state: Any, drop: Any, fraction: Any) -> Any:
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


@solve_frame.member(RigidFrame)
def _solve_frame(frame: RigidFrame, mesh: Any, state: Any, system: Any, done: Any) -> Any:
    return banded.solve_frame(system, done)


@contact_points.member(RigidFrame)
def _contact_points(frame: RigidFrame, mesh: Any) -> int:
    return 4


@contact_point.member(RigidFrame)
@corner_point.member(RigidFrame)
def _corner_point(frame: RigidFrame, mesh: Any, corner: Any, state: Any, velocity: Any) -> Any:
    rx, ry = corner_arm(frame, corner, cos(state[2]), sin(state[2]))
    vx = velocity[0] - ry * velocity[2]
    return state[0] + rx, state[1] + ry, vx, velocity[1] + rx * velocity[2]


@point_mass.member(RigidFrame)
def _point_mass(frame: RigidFrame, mesh: Any, point: Any, state: Any) -> Any:
    rx, _ = corner_arm(frame, point, cos(state[2]), sin(state[2]))
    return 1.0 / (1.0 / frame.mass + rx * rx / frame.inertia)


@point_weight.member(RigidFrame)
def _point_weight(frame: RigidFrame, mesh: Any, point: Any, contact: Any) -> Any:
    return contact_weights(contact)[1]


@frame_box.member(RigidFrame)
def _frame_box(frame: RigidFrame, mesh: Any, state: Any, velocity: Any) -> FrameBox:
    return FrameBox(
        state[0],
        state[1],
        cos(state[2]),
        sin(state[2]),
        velocity[2],
        frame.half_span,
        frame.mount_y,
        frame.foot_y,
        frame.top_y,
    )


@rest_frame.member(RigidFrame)
def _rest_frame(frame: RigidFrame, mesh: Any, state: Any, gap: Any) -> None:
    state[0] = 0.0
    state[1] = gap - frame.foot_y
    state[2] = 0.0


@frame_mass.member(RigidFrame)
def _frame_mass(frame: RigidFrame, mesh: Any, coordinate: Any) -> Any:
    return where(coordinate == 2, frame.inertia, frame.mass)


@frame_moments.member(RigidFrame)
def _frame_moments(frame: RigidFrame, mesh: Any, vector: Any) -> Any:
    return frame.mass * vector[0], frame.mass * vector[1]


@slide_frame.member(RigidFrame)
def _slide_frame(frame: RigidFrame, mesh: Any, vector: Any, along_x: Any) -> None:
    vector[0] = vector[0] + along_x


@frame_energy.member(RigidFrame)
def _frame_energy(frame: RigidFrame, mesh: Any, state: Any) -> Any:
    return 0.0 * state[0]


@frame_dissipation.member(RigidFrame)
def _frame_dissipation(
    frame: RigidFrame, damping: Any, mesh: Any, state: Any, velocity: Any
) -> Any:
    return 0.0 * state[0]
