"""Residual and tangent of one stage: M (V - drift) rate + grad V + damping + contact = 0.

Every integrator solves this problem, with V = (q - origin) rate and rate = 1 / (gamma h); a static
equilibrium is the same with rate = 0.
"""

from typing import Any, NamedTuple

from snapjump.clamp.base import clamp_angles
from snapjump.contact.base import (
    bounce_rate_squared,
    contact_force,
    contact_reach,
    contact_weights,
    has_contact,
)
from snapjump.damping.base import mass_damping
from snapjump.discretization.base import add_internal_forces, clamp_offset, has_elements
from snapjump.frame.base import add_frame_forces, condense_ends, end_tangents, frame_dofs
from snapjump.friction.base import has_friction, is_lagged, slip
from snapjump.load.base import gravity, pull, tip_load
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, any_true, maximum, minimum, where


class Motion(NamedTuple):
    """Time of the stage (T), rate 1/(gamma h), and the static anchor of x (EI/L^3)."""

    time: Any
    rate_factor: Any
    anchor: Any


class Assembly(NamedTuple):
    """Largest force in play (EI/L^2), smallest gap (L), and the square of the fastest contact
    frequency sqrt(k/m) (1/T)."""

    largest_force: Any
    smallest_gap: Any
    contact_rate_squared: Any


@kernel
def clear_border(system: Any, zero: Any) -> None:
    """Zero the frame's rows of the linear system."""
    for j in range(system.border.shape[0]):
        for k in range(3):
            system.border[j, k] = zero
    for k in range(3):
        system.frame_residual[k] = zero
        for m in range(3):
            system.square[k, m] = zero


@routine
def add_inertia(model: Any, motion: Any, masses: Any, work: Any) -> Any:
    """Begin the system with inertia, drag and weight of the nodes; returns the largest force."""
    offset = frame_dofs(model.frame)
    rate = motion.rate_factor
    drag = mass_damping(model.damping)
    fall = gravity(model.load)
    tug = pull(model.load)
    diagonal = (rate + drag) * rate
    zero = 0.0 * rate
    largest = zero
    band = work.system.band
    residual = work.system.residual
    for node in range(masses.shape[0]):
        mass = masses[node]
        row = 2 * node
        i = row + offset
        vx = (work.state[i] - work.origin[i]) * rate
        vy = (work.state[i + 1] - work.origin[i + 1]) * rate
        ax = (vx - work.drift[i]) * rate
        ay = (vy - work.drift[i + 1]) * rate
        residual[row] = mass * (ax + drag * vx - tug)
        residual[row + 1] = mass * (ay + drag * vy + fall)
        band[row, 0] = mass * diagonal
        band[row + 1, 0] = mass * diagonal
        for k in range(1, 6):
            band[row, k] = zero
            band[row + 1, k] = zero
        largest = maximum(largest, mass * (absolute(ax) + absolute(ay)))
    return largest


@routine
def add_node_contact(model: Any, motion: Any, masses: Any, work: Any) -> Any:
    """Contact and friction of the free nodes; returns the same figures as an assembly."""
    offset = frame_dofs(model.frame)
    contact = model.contact
    friction = model.friction
    reach = contact_reach(contact)
    weight, _ = contact_weights(contact)
    rate = motion.rate_factor
    smallest = 0.0 * rate + 1.0e30
    largest = 0.0 * rate
    fastest = 0.0 * rate
    residual = work.system.residual
    band = work.system.band
    for node in range(masses.shape[0]):
        if masses[node] == 0.0:
            continue
        row = 2 * node
        i = row + offset
        gap = work.state[i + 1]
        smallest = minimum(smallest, gap)
        near = gap < reach
        if has_friction(friction) and is_lagged(friction):
            begun = work.start[i + 1]
            was_near = begun < reach
            if any_true(was_near):
                normal, _ = contact_force(contact, where(was_near, begun, reach))
                velocity = work.velocity[0, i]
                ratio, _ = slip(friction, velocity, 0.0 * velocity)
                residual[row] += ratio * normal * weight
        if any_true(near):
            force, stiffness = contact_force(contact, where(near, gap, reach))
            force = force * weight
            stiffness = stiffness * weight
            residual[row + 1] -= force
            band[row + 1, 0] += stiffness
            largest = maximum(largest, force)
            speed = (gap - work.origin[i + 1]) * rate
            fastest = maximum(fastest, bounce_rate_squared(stiffness, masses[node], speed))
            if has_friction(friction) and not is_lagged(friction):
                velocity = (work.state[i] - work.origin[i]) * rate
                ratio, slope = slip(friction, velocity, work.slip[node + 4])
                work.slip[node + 4] = velocity
                # d(drag)/d(gap) is left out: it alone would make the band unsymmetric.
                residual[row] += ratio * force
                band[row, 0] += force * slope * rate
    return Assembly(largest, smallest, fastest)


@routine
def assemble(model: Any, motion: Any, masses: Any, work: Any) -> Assembly:
    """Fill the linear system at the current state; ``masses`` is zero at slave nodes."""
    system = work.system
    dofs = frame_dofs(model.frame)
    if dofs > 0:
        clear_border(system, 0.0 * motion.rate_factor)
    largest = add_inertia(model, motion, masses, work)
    force_x, force_y, _ = tip_load(model.load)
    last = 2 * masses.shape[0] - 2
    system.residual[last] -= force_x
    system.residual[last + 1] -= force_y
    smallest = 0.0 * motion.rate_factor + 1.0e30
    fastest = 0.0 * motion.rate_factor
    if has_contact(model.contact):
        touch = add_node_contact(model, motion, masses, work)
        largest = maximum(largest, touch.largest_force)
        smallest = minimum(smallest, touch.smallest_gap)
        fastest = maximum(fastest, touch.contact_rate_squared)
    if has_elements(model.discretization):
        angles = clamp_angles(model.clamp, motion.time)
        turn_rate = 0.0 * motion.rate_factor
        if dofs > 0:
            turn_rate = (work.state[2] - work.origin[2]) * motion.rate_factor
        tangents = end_tangents(model.frame, model.load, angles, work.state, turn_rate)
        left, right, internal = add_internal_forces(
            model.discretization,
            model.damping,
            work.state[dofs:],
            work.origin[dofs:],
            motion.rate_factor,
            tangents,
            system.residual,
            system.band,
        )
        largest = maximum(largest, internal)
        offset = clamp_offset(model.discretization)
        condense_ends(model.frame, tangents, offset, left, right, work.state, system)
    frame = add_frame_forces(model.frame, model, motion, work)
    return Assembly(
        maximum(largest, frame.largest_force),
        minimum(smallest, frame.smallest_gap),
        maximum(fastest, frame.contact_rate_squared),
    )
