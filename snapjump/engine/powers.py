"""Powers of friction, damping and clamps at a stage: what the energy ledger adds up."""

from typing import Any

from snapjump.clamp.base import clamp_angles
from snapjump.contact.base import contact_force, contact_reach, contact_weights, has_contact
from snapjump.damping.base import mass_damping
from snapjump.discretization.base import (
    TURN_INERTIA,
    chain_powers,
    clamp_offset,
    has_elements,
    node_dofs,
)
from snapjump.frame.base import (
    contact_point,
    contact_points,
    end_tangents,
    frame_dissipation,
    frame_dofs,
    frame_mass,
    mount_turning,
    point_weight,
)
from snapjump.friction.base import has_friction, is_lagged, slip
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import where


@kernel
def sliding_force(model: Any, gap: Any, velocity: Any, weight: Any) -> Any:
    """Friction force (EI/L^2) of a point at a gap (L) that slides with a velocity (L/T)."""
    reach = contact_reach(model.contact)
    near = gap < reach
    normal, _ = contact_force(model.contact, where(near, gap, reach))
    ratio, _ = slip(model.friction, velocity, 0.0 * velocity)
    return ratio * normal * weight


@routine
def friction_power(model: Any, masses: Any, work: Any, state: Any, velocity: Any) -> Any:
    """Power that friction takes out (EI/(L T)); lagged laws use the step's beginning."""
    mesh = work.mesh
    offset = frame_dofs(model.frame, mesh)
    dofs = node_dofs(model.discretization)
    by_node, _ = contact_weights(model.contact)
    lagged = is_lagged(model.friction)
    power = 0.0 * state[0]
    for node in range(masses.shape[0]):
        if masses[node] > 0.0:
            i = dofs * node + offset
            gap = work.start[i + 1] if lagged else state[i + 1]
            speed = work.velocity[0, i] if lagged else velocity[i]
            power = power + sliding_force(model, gap, speed, by_node) * velocity[i]
    for point in range(contact_points(model.frame, mesh)):
        _, gap, speed = contact_point(model.frame, mesh, point, state, velocity)
        weight = point_weight(model.frame, mesh, point, model.contact)
        force_gap = gap
        force_speed = speed
        if lagged:
            _, force_gap, force_speed = contact_point(
                model.frame, mesh, point, work.start, work.velocity[0]
            )
        power = power + sliding_force(model, force_gap, force_speed, weight) * speed
    return power


@routine
def powers(model: Any, masses: Any, work: Any, time: Any, state: Any, velocity: Any) -> Any:
    """Losses by friction and by damping, and the power that the clamps put in (EI/(L T))."""
    mesh = work.mesh
    offset = frame_dofs(model.frame, mesh)
    dofs = node_dofs(model.discretization)
    friction = 0.0 * state[0]
    damping = 0.0 * state[0]
    clamps = 0.0 * state[0]
    if has_contact(model.contact) and has_friction(model.friction):
        friction = friction_power(model, masses, work, state, velocity)
    drag = mass_damping(model.damping)
    for node in range(masses.shape[0]):
        i = dofs * node + offset
        speed_squared = velocity[i] * velocity[i] + velocity[i + 1] * velocity[i + 1]
        if dofs == 3:
            speed_squared = speed_squared + TURN_INERTIA * velocity[i + 2] * velocity[i + 2]
        damping = damping + drag * masses[node] * speed_squared
    for k in range(offset):
        mass = frame_mass(model.frame, mesh, k)
        damping = damping + drag * mass * velocity[k] * velocity[k]
    damping = damping + frame_dissipation(model.frame, model.damping, mesh, state, velocity)
    if has_elements(model.discretization):
        angles = clamp_angles(model.clamp, time)
        turning = mount_turning(model.frame, mesh, state, velocity)
        tangents = end_tangents(model.frame, mesh, model.load, angles, state, turning)
        chain = chain_powers(
            model.discretization, model.damping, state[offset:], velocity[offset:], tangents
        )
        damping = damping + chain.dissipation
        shift = clamp_offset(model.discretization)
        left_pull = chain.left_x * tangents.left_y - chain.left_y * tangents.left_x
        right_pull = chain.right_x * tangents.right_y - chain.right_y * tangents.right_x
        clamps = (chain.left_moment + shift * left_pull) * angles.left_rate
        clamps = clamps + (chain.right_moment + shift * right_pull) * angles.right_rate
    return friction, damping, clamps
