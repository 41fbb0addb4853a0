"""Powers of friction, contact, damping and clamps at a stage: what the energy ledger adds up."""

from typing import Any, NamedTuple

from snapjump.clamp.base import clamp_angles
from snapjump.contact.base import (
    Approach,
    acts,
    contact_loss,
    contact_reach,
    contact_weights,
    force_if_acting,
    has_contact,
)
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
    point_mass,
    point_weight,
)
from snapjump.friction.base import has_friction, is_lagged, slip
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import where


class Powers(NamedTuple):
    """Losses by friction, damping and contact, and the power that clamps put in (EI/(L T))."""

    friction: Any
    damping: Any
    clamps: Any
    contact: Any


class Point(NamedTuple):
    """Gap (L) and velocity (L/T) of a point that may touch the ground."""

    gap: Any
    vx: Any
    vy: Any


@kernel
def node_point(model: Any, mesh: Any, node: Any, state: Any, velocity: Any) -> Point:
    """A node of the beam as a point."""
    i = node_dofs(model.discretization) * node + frame_dofs(model.frame, mesh)
    return Point(state[i + 1], velocity[i], velocity[i + 1])


@kernel
def frame_point(model: Any, mesh: Any, point: Any, state: Any, velocity: Any) -> Point:
    """One of the frame's own points."""
    _, gap, vx, vy = contact_point(model.frame, mesh, point, state, velocity)
    return Point(gap, vx, vy)


@kernel
def approach_of(motion: Any, now: Point, begun: Point, mass: Any) -> Approach:
    """How a point comes near the ground within a stage that began the step at ``begun``."""
    rate = motion.rate_factor
    return Approach(now.vy, rate, begun.gap, begun.vy, mass * rate * motion.inertia_rate)


@kernel
def point_losses(model: Any, motion: Any, now: Point, begun: Point, mass: Any, weight: Any) -> Any:
    """Power that friction and the contact law take out at a point; lagged friction uses the
    step's beginning."""
    approach = approach_of(motion, now, begun, mass)
    active = acts(model.contact, now.gap, approach)
    gap = where(active, now.gap, contact_reach(model.contact))
    lost = where(active, contact_loss(model.contact, gap, approach), 0.0) * weight
    rubbed = 0.0 * now.gap
    if has_friction(model.friction):
        sliding = now.vx
        _, normal, _ = force_if_acting(model.contact, now.gap, approach)
        if is_lagged(model.friction):
            zero = 0.0 * now.gap
            before = Approach(begun.vy, zero, begun.gap, begun.vy, zero)
            sliding = begun.vx
            _, normal, _ = force_if_acting(model.contact, begun.gap, before)
        ratio, _ = slip(model.friction, sliding, 0.0 * sliding)
        rubbed = ratio * normal * weight * now.vx
    return rubbed, lost


@routine
def contact_powers(
    model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any
) -> Any:
    """Power that friction and contact take out, all points together."""
    mesh = work.mesh
    by_node, _ = contact_weights(model.contact)
    friction = 0.0 * state[0]
    contact = 0.0 * state[0]
    before = work.velocity[0]
    for node in range(masses.shape[0]):
        if masses[node] > 0.0:
            now = node_point(model, mesh, node, state, velocity)
            begun = node_point(model, mesh, node, work.start, before)
            rubbed, lost = point_losses(model, motion, now, begun, masses[node], by_node)
            friction = friction + rubbed
            contact = contact + lost
    for point in range(contact_points(model.frame, mesh)):
        now = frame_point(model, mesh, point, state, velocity)
        begun = frame_point(model, mesh, point, work.start, before)
        mass = point_mass(model.frame, mesh, point, state)
        weight = point_weight(model.frame, mesh, point, model.contact)
        rubbed, lost = point_losses(model, motion, now, begun, mass, weight)
        friction = friction + rubbed
        contact = contact + lost
    return friction, contact


@routine
def powers(model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any) -> Powers:
    """The :class:`Powers` of a stage's state and velocity."""
    mesh = work.mesh
    offset = frame_dofs(model.frame, mesh)
    dofs = node_dofs(model.discretization)
    friction = 0.0 * state[0]
    contact = 0.0 * state[0]
    damping = 0.0 * state[0]
    clamps = 0.0 * state[0]
    if has_contact(model.contact):
        friction, contact = contact_powers(model, motion, masses, work, state, velocity)
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
        angles = clamp_angles(model.clamp, motion.time)
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
    return Powers(friction, damping, clamps, contact)
