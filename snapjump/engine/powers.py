"""Powers of friction, contact, damping, drag and clamps at a stage: the energy ledger's sums."""

from typing import Any, NamedTuple

from snapjump.discretization.base import ROTARY_INERTIA
from snapjump.engine.centre_of_mass import mean_of, whole_mass
from snapjump.engine.points import contact_powers
from snapjump.number.dispatch import kernel, routine


class Powers(NamedTuple):
    """Losses by friction, damping, contact and drag, and the power that clamps put in
    (EI/(L T))."""

    friction: Any
    damping: Any
    clamps: Any
    contact: Any
    drag: Any


@kernel
def clamp_torques(model: Any, chain: Any, tangents: Any) -> Any:
    """Torques (EI/L) of the left and of the right clamp on the beam, in the sense in which they
    turn, of a chain's :class:`~snapjump.discretization.base.ChainPowers`."""
    shift = model.discretization.clamp_distance()
    left_pull = chain.left_x * tangents.left_y - chain.left_y * tangents.left_x
    right_pull = chain.right_x * tangents.right_y - chain.right_y * tangents.right_x
    return chain.left_moment + shift * left_pull, chain.right_moment + shift * right_pull


class Held(NamedTuple):
    """What a beam and its clamps do to each other: the clamps' directions
    (:class:`~snapjump.discretization.base.EndTangents`), the power that damping takes out of the
    beam (EI/(L T)), the clamps' torques on it (EI/L), and the power that they put in."""

    tangents: Any
    dissipation: Any
    left: Any
    right: Any
    power: Any


@kernel
def held_beam(model: Any, mesh: Any, angles: Any, state: Any, velocity: Any) -> Held:
    """What the clamps at these angles and the beam of a state and velocity do to each other."""
    rotations = model.frame.mount_rotations(mesh, state, velocity)
    tangents = model.frame.end_tangents(mesh, model.load, angles, state, rotations)
    first = model.frame.dofs(mesh)
    chain = model.discretization.chain_powers(
        model.damping, state[first:], velocity[first:], tangents
    )
    left, right = clamp_torques(model, chain, tangents)
    power = left * angles.left_rate
    power = power + right * angles.right_rate
    power = power + 0.5 * angles.apart_rate * (chain.right_x - chain.left_x)
    return Held(tangents, chain.dissipation, left, right, power)


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
            speed_squared = speed_squared + ROTARY_INERTIA * velocity[i + 2] * velocity[i + 2]
        damping = damping + drag * masses[node] * speed_squared
    for k in range(offset):
        mass = model.frame.mass_of(mesh, k)
        damping = damping + drag * mass * velocity[k] * velocity[k]
    damping = damping + model.frame.dissipation(model.damping, mesh, state, velocity)
    if model.discretization.has_elements():
        beam = held_beam(model, mesh, model.clamp.angles(motion.time), state, velocity)
        damping = damping + beam.dissipation
        clamps = beam.power
    air = 0.0 * state[0]
    if model.drag.exists():
        vx, vy = mean_of(model, masses, mesh, velocity)
        air = -whole_mass(model, masses, mesh) * (work.air[0] * vx + work.air[1] * vy)
    return Powers(friction, damping, clamps, contact, air)
