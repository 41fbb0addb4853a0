"""Contact and friction of a point that is a node: of the beam, or of an elastic frame."""

from typing import Any

from snapjump.contact.base import bounce_rate_squared, contact_force, contact_reach
from snapjump.frame.base import FrameForces
from snapjump.friction.base import has_friction, is_lagged, slip
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true, maximum, minimum, where


@kernel
def add_point_contact(
    model: Any,
    motion: Any,
    work: Any,
    mass: Any,
    weight: Any,
    i: Any,
    row: Any,
    slot: Any,
    residual: Any,
    band: Any,
    figures: FrameForces,
) -> FrameForces:
    """Add contact and friction of a node; returns the figures with its own.

    ``mass`` is what bounces with it, ``weight`` the factor of the contact force. Its x is
    coordinate ``i`` of the state, ``row`` of residual and band; ``slot``: its place in ``slip``.
    """
    contact = model.contact
    friction = model.friction
    reach = contact_reach(contact)
    rate = motion.rate_factor
    gap = work.state[i + 1]
    largest = figures.largest_force
    smallest = minimum(figures.smallest_gap, gap)
    fastest = figures.contact_rate_squared
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
        fastest = maximum(fastest, bounce_rate_squared(stiffness, mass, speed))
        if has_friction(friction) and not is_lagged(friction):
            velocity = (work.state[i] - work.origin[i]) * rate
            previous = work.slip[slot]
            ratio, slope = slip(friction, velocity, previous)
            work.slip[slot] = where(near, velocity, previous)
            # d(drag)/d(gap) is left out: it alone would make the band unsymmetric.
            residual[row] += ratio * force
            band[row, 0] += force * slope * rate
    return FrameForces(largest, smallest, fastest)
