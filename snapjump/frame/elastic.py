"""An elastic frame: the paper's open chain of nodes, leg - top - leg, far stiffer than the beam.

The beam's ends hang from one edge of either leg (a mount): they follow its middle, an inset away
from it, and turn with it. All nodes have mass and weight; each can touch the ground.
"""

from typing import Any

from snapjump.contact.base import has_contact
from snapjump.damping.base import mass_damping
from snapjump.discretization.base import (
    HALF_BANDWIDTH,
    EndTangents,
    clamp_offset,
    node_dofs,
)
from snapjump.frame.base import (
    FrameForces,
    Turning,
    add_frame_forces,
    border_width,
    condense_first,
    condense_last,
    end_tangents,
    frame_dissipation,
    frame_dofs,
    frame_energy,
    limit_frame_step,
    mount_turning,
    place_ends,
    solve_frame,
)
from snapjump.frame.elastic_body import ElasticFrame
from snapjump.frame.elastic_chain import add_chain_forces, chain_dissipation, chain_energy
from snapjump.frame.elastic_mesh import (
    DOFS,
    LEFT_CORNER,
    LEFT_MOUNT,
    RIGHT_CORNER,
    Mount,
    is_corner,
    mount_at,
    node_count,
    node_mass,
    right_mount,
    weight_at,
)
from snapjump.frame.elastic_solve import solve_chain
from snapjump.frame.ends import move_first, move_last
from snapjump.frame.point_contact import add_point_contact
from snapjump.load.base import gravity
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, any_true, cos, maximum, minimum, sin, sqrt, where


@frame_dofs.member(ElasticFrame)
def _frame_dofs(frame: ElasticFrame, mesh: Any) -> Any:
    return mesh[DOFS]


@border_width.member(ElasticFrame)
def _border_width(frame: ElasticFrame) -> int:
    return 6


@kernel
def turning_of(edge: Any, state: Any, vector: Any) -> Any:
    """Turning of an edge whose nodes move by ``vector``."""
    mount = mount_at(edge, 1.0, state)
    i = 2 * edge
    along_x = vector[i + 2] - vector[i]
    along_y = vector[i + 3] - vector[i + 1]
    return mount.slope_x * along_x + mount.slope_y * along_y


@mount_turning.member(ElasticFrame)
def _mount_turning(frame: ElasticFrame, mesh: Any, state: Any, vector: Any) -> Turning:
    return Turning(
        turning_of(mesh[LEFT_MOUNT], state, vector),
        turning_of(right_mount(mesh), state, vector),
    )


@kernel
def turned(mount: Mount, angle: Any) -> Any:
    """The mount's direction turned by an angle (rad)."""
    c = cos(angle)
    s = sin(angle)
    return mount.cx * c - mount.cy * s, mount.cy * c + mount.cx * s


@kernel
def right_tangent(frame: Any, mesh: Any, angle: Any, state: Any) -> Any:
    """Tangent of the beam at the right clamp, turned by an angle against its mount.

    A clamp that does not follow all of its leg's bending (against the line between the mounts) is
    turned back; the tangent matrix leaves that out, the legs being stiff.
    """
    left = mount_at(mesh[LEFT_MOUNT], 1.0, state)
    right = mount_at(right_mount(mesh), -1.0, state)
    x = right.x - left.x
    y = right.y - left.y
    bending = (x * right.cy - y * right.cx) / sqrt(x * x + y * y)
    return turned(right, angle - (1.0 - frame.right_follow) * bending)


@end_tangents.member(ElasticFrame)
def _end_tangents(
    frame: ElasticFrame, mesh: Any, load: Any, angles: Any, state: Any, turning: Turning
) -> Any:
    left_x, left_y = turned(mount_at(mesh[LEFT_MOUNT], 1.0, state), -angles.left)
    right_x, right_y = right_tangent(frame, mesh, angles.right, state)
    zero = 0.0 * left_x
    return EndTangents(
        left_x,
        left_y,
        turning.left - angles.left_rate,
        right_x,
        right_y,
        turning.right + angles.right_rate,
        zero,
        zero,
    )


@place_ends.member(ElasticFrame)
def _place_ends(
    frame: ElasticFrame, mesh: Any, discretization: Any, angles: Any, state: Any
) -> None:
    offset = clamp_offset(discretization)
    left = mount_at(mesh[LEFT_MOUNT], 1.0, state)
    right = mount_at(right_mount(mesh), -1.0, state)
    left_x, left_y = turned(left, -angles.left)
    right_x, right_y = right_tangent(frame, mesh, angles.right, state)
    first = mesh[DOFS]
    last = state.shape[0] - node_dofs(discretization)
    state[first] = left.x + frame.inset * left.cx + offset * left_x
    state[first + 1] = left.y + frame.inset * left.cy + offset * left_y
    state[last] = right.x - frame.inset * right.cx - offset * right_x
    state[last + 1] = right.y - frame.inset * right.cy - offset * right_y


@kernel
def spread_mount(edge: Any, column: Any, state: Any, system: Any) -> None:
    """Move a mount's force and moment, from ``column`` of ``mounts``, onto its edge's nodes, with
    the stiffness that the moment has because the edge's direction is not linear."""
    mounts = system.mounts
    residual = system.frame_residual
    band = system.frame_band
    mount = mount_at(edge, 1.0, state)
    fx = 0.5 * mounts[column]
    fy = 0.5 * mounts[column + 1]
    moment = mounts[column + 2]
    i = 2 * edge
    residual[i] += fx - moment * mount.slope_x
    residual[i + 1] += fy - moment * mount.slope_y
    residual[i + 2] += fx + moment * mount.slope_x
    residual[i + 3] += fy + moment * mount.slope_y
    xx = -2.0 * moment * mount.slope_x * mount.slope_y
    xy = moment * (mount.slope_x * mount.slope_x - mount.slope_y * mount.slope_y)
    j = i + HALF_BANDWIDTH
    for node in range(2):
        band[j + 2 * node, 0] += xx
        band[j + 2 * node, 1] += xy
        band[j + 2 * node + 1, 0] -= xx
    band[j, 2] -= xx
    band[j, 3] -= xy
    band[j + 1, 1] -= xy
    band[j + 1, 2] += xx
    for a in range(3):
        mounts[column + a] = 0.0 * moment


@condense_first.member(ElasticFrame)
def _condense_first(
    frame: ElasticFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    offset = clamp_offset(discretization)
    mount = mount_at(mesh[LEFT_MOUNT], 1.0, state)
    arm_x = frame.inset * mount.cx + offset * tangents.left_x
    arm_y = frame.inset * mount.cy + offset * tangents.left_y
    move_first(discretization, hinge, arm_x, arm_y, system.mounts, system)
    spread_mount(mesh[LEFT_MOUNT], 0, state, system)


@condense_last.member(ElasticFrame)
def _condense_last(
    frame: ElasticFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    offset = clamp_offset(discretization)
    mount = mount_at(right_mount(mesh), -1.0, state)
    arm_x = -frame.inset * mount.cx - offset * tangents.right_x
    arm_y = -frame.inset * mount.cy - offset * tangents.right_y
    last = (state.shape[0] - mesh[DOFS]) // node_dofs(discretization) - 1
    move_last(discretization, last, hinge, arm_x, arm_y, system.mounts, system, 3)
    spread_mount(right_mount(mesh), 3, state, system)


@kernel
def clear_mounts(system: Any, zero: Any) -> None:
    """Zero the mounts' matrix and right-hand side."""
    for k in range(6):
        system.mounts[k] = zero
        for m in range(6):
            system.square[k, m] = zero


@add_frame_forces.member(ElasticFrame)
def _add_frame_forces(frame: ElasticFrame, model: Any, motion: Any, work: Any) -> Any:
    mesh = work.mesh
    state = work.state
    residual = work.system.frame_residual
    band = work.system.frame_band[HALF_BANDWIDTH:]
    rate = motion.rate_factor
    drag = mass_damping(model.damping)
    fall = gravity(model.load)
    zero = 0.0 * rate
    clear_mounts(work.system, zero)
    figures = FrameForces(zero, zero + 1.0e30, zero)
    for node in range(node_count(mesh)):
        i = 2 * node
        mass = node_mass(frame, mesh, node)
        vx = (state[i] - work.origin[i]) * rate
        vy = (state[i + 1] - work.origin[i + 1]) * rate
        ax = (vx - work.drift[i]) * motion.inertia_rate
        ay = (vy - work.drift[i + 1]) * motion.inertia_rate
        residual[i] = mass * (ax + drag * vx)
        residual[i + 1] = mass * (ay + drag * vy + fall)
        band[i, 0] = mass * (motion.inertia_rate + drag) * rate
        band[i + 1, 0] = mass * (motion.inertia_rate + drag) * rate
        inertial = mass * (absolute(ax) + absolute(ay) + fall)
        figures = FrameForces(
            maximum(figures.largest_force, inertial),
            figures.smallest_gap,
            figures.contact_rate_squared,
        )
        if has_contact(model.contact):
            weight = weight_at(frame, mesh, node, model.contact)
            if any_true(weight > 0.0):
                figures = add_point_contact(
                    model,
                    motion,
                    work,
                    frame.bouncing_mass,
                    weight,
                    i,
                    i,
                    node,
                    residual,
                    band,
                    figures,
                )
    # Statics leaves x undetermined: a spring that ends up without force holds the top's middle.
    middle = (mesh[LEFT_CORNER] + mesh[RIGHT_CORNER]) // 2
    place = (middle - mesh[LEFT_CORNER]) * frame.top_length - frame.half_span
    residual[2 * middle] += motion.anchor * (state[2 * middle] - place)
    band[2 * middle, 0] += motion.anchor
    largest = add_chain_forces(frame, mesh, model.damping, state, work.origin, rate, residual, band)
    return FrameForces(
        maximum(figures.largest_force, largest),
        figures.smallest_gap,
        figures.contact_rate_squared,
    )


@solve_frame.member(ElasticFrame)
def _solve_frame(frame: ElasticFrame, mesh: Any, state: Any, system: Any, done: Any) -> Any:
    return solve_chain(mesh, state, system, done)


@limit_frame_step.member(ElasticFrame)
def _limit_frame_step(frame: ElasticFrame, mesh: Any, state: Any, drop: Any, fraction: Any) -> Any:
    share = 1.0 + 0.0 * state[0]
    light = frame.node_weight + frame.length_weight <= 0.0
    for node in range(node_count(mesh)):
        if is_corner(mesh, node) or not any_true(light):
            fall = drop[2 * node + 1]
            allowed = (1.0 - fraction) * state[2 * node + 1]
            beyond = fall > allowed
            if any_true(beyond):
                share = minimum(share, where(beyond, allowed / absolute(fall), 1.0))
    return share


@frame_energy.member(ElasticFrame)
def _frame_energy(frame: ElasticFrame, mesh: Any, state: Any) -> Any:
    return chain_energy(frame, mesh, state)


@frame_dissipation.member(ElasticFrame)
def _frame_dissipation(
    frame: ElasticFrame, damping: Any, mesh: Any, state: Any, velocity: Any
) -> Any:
    return chain_dissipation(frame, damping, mesh, state, velocity)
