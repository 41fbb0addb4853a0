"""Powers of friction, contact, damping and clamps at a stage: what the energy ledger adds up."""

from typing import Any, NamedTuple

from snapjump.contact.base import Approach, force_if_acting
from snapjump.discretization.base import TURN_INERTIA
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
    i = model.discretization.node_dofs() * node + model.frame.dofs(mesh)
    return Point(state[i + 1], velocity[i], velocity[i + 1])


@kernel
def frame_point(model: Any, mesh: Any, point: Any, state: Any, velocity: Any) -> Point:
    """One of the frame's own points."""
    _, gap, vx, vy = model.frame.contact_point(mesh, point, state, velocity)
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
    active = model.contact.active(now.gap, approach)
    gap = where(active, now.gap, model.contact.reach())
    lost = where(active, model.contact.loss(gap, approach), 0.0) * weight
    rubbed = 0.0 * now.gap
    if model.friction.exists():
        sliding = now.vx
        _, normal, _ = force_if_acting(model.contact, now.gap, approach)
        if model.friction.is_lagged():
            zero = 0.0 * now.gap
            before = Approach(begun.vy, zero, begun.gap, begun.vy, zero)
            sliding = begun.vx
            _, normal, _ = force_if_acting(model.contact, begun.gap, before)
        ratio = model.friction.ratio(sliding)
        rubbed = ratio * normal * weight * now.vx
    return rubbed, lost


@routine
def contact_powers(
    model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any
) -> Any:
    """Power that friction and contact take out, all points together."""
    mesh = work.mesh
    share = model.ground.node_share
    friction = 0.0 * state[0]
    contact = 0.0 * state[0]
    before = work.velocity[0]
    for node in range(masses.shape[0]):
        if masses[node] > 0.0:
            now = node_point(model, mesh, node, state, velocity)
            begun = node_point(model, mesh, node, work.start, before)
            rubbed, lost = point_losses(model, motion, now, begun, masses[node], share)
            friction = friction + rubbed
            contact = contact + lost
    for point in range(model.frame.contact_points(mesh)):
        now = frame_point(model, mesh, point, state, velocity)
        begun = frame_point(model, mesh, point, work.start, before)
        mass = model.frame.point_mass(mesh, point, state)
        weight = model.frame.point_share(mesh, point, model.ground)
        rubbed, lost = point_losses(model, motion, now, begun, mass, weight)
        friction = friction + rubbed
        contact = contact + lost
    return friction, contact


@routine
def powers(model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any) -> Powers:
    """The :class:`Powers` of a stage's state and velocity."""
    mesh = work.mesh
    offset = model.frame.dofs(mesh)
    dofs = model.discretization.node_dofs()
    friction = 0.0 * state[0]
    contact = 0.0 * state[0]
    damping = 0.0 * state[0]
    clamps = 0.0 * state[0]
    if model.contact.exists():
        friction, contact = contact_powers(model, motion, masses, work, state, velocity)
    drag = model.damping.drag()
    for node in range(masses.shape[0]):
        i = dofs * node + offset
        speed_squared = velocity[i] * velocity[i] + velocity[i + 1] * velocity[i + 1]
        if dofs == 3:
            speed_squared = speed_squared + TURN_INERTIA * velocity[i + 2] * velocity[i + 2]
        damping = damping + drag * masses[node] * speed_squared
    for k in range(offset):
        mass = model.frame.mass_of(mesh, k)
        damping = damping + drag * mass * velocity[k] * velocity[k]
    damping = damping + model.frame.dissipation(model.damping, mesh, state, velocity)
    if model.discretization.has_elements():
        angles = model.clamp.angles(motion.time)
        turning = model.frame.mount_turning(mesh, state, velocity)
        tangents = model.frame.end_tangents(mesh, model.load, angles, state, turning)
        chain = model.discretization.chain_powers(
            model.damping, state[offset:], velocity[offset:], tangents
        )
        damping = damping + chain.dissipation
        shift = model.discretization.clamp_distance()
        left_pull = chain.left_x * tangents.left_y - chain.left_y * tangents.left_x
        right_pull = chain.right_x * tangents.right_y - chain.right_y * tangents.right_x
        clamps = (chain.left_moment + shift * left_pull) * angles.left_rate
        clamps = clamps + (chain.right_moment + shift * right_pull) * angles.right_rate
    return Powers(friction, damping, clamps, contact)
