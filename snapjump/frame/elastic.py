"""An elastic frame: the paper's open chain of nodes, leg - top - leg, far stiffer than the beam.

The beam's ends hang from one edge of either leg (a mount): they follow its middle, an inset away
from it, and turn with it. All nodes have mass and weight; each can touch the ground.
"""

from typing import Any

from snapjump.contact.base import has_contact
from snapjump.damping.base import mass_damping
from snapjump.discretization.base import (
    HALF_BANDWIDTH,
)
from snapjump.frame.base import (
    FrameForces,
    add_frame_forces,
    border_width,
    frame_dissipation,
    frame_dofs,
    frame_energy,
    limit_frame_step,
    solve_frame,
)
from snapjump.frame.elastic_body import ElasticFrame
from snapjump.frame.elastic_chain import add_chain_forces, chain_dissipation, chain_energy
from snapjump.frame.elastic_mesh import (
    DOFS,
    LEFT_CORNER,
    RIGHT_CORNER,
    is_corner,
    node_count,
    node_mass,
    weight_at,
)
from snapjump.frame.elastic_mounts import clear_mounts
from snapjump.frame.elastic_solve import solve_chain
from snapjump.frame.point_contact import add_point_contact
from snapjump.load.base import gravity
from snapjump.number.functions import absolute, any_true, maximum, minimum, where


@frame_dofs.member(ElasticFrame)
def _frame_dofs(frame: ElasticFrame, mesh: Any) -> Any:
    return mesh[DOFS]


@border_width.member(ElasticFrame)
def _border_width(frame: ElasticFrame) -> int:
    return 6


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
