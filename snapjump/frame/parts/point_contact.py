"""Contact and friction of a point that is a node: of the beam, or of an elastic frame."""

from typing import Any

from snapjump.contact.base import Approach, force_if_acting, note_contact, pressing_force
from snapjump.frame.base import FrameForces
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
    rate = motion.rate_factor
    gap = work.state[i + 1]
    begun = work.start[i + 1]
    begun_speed = work.velocity[0, i + 1]
    speed = (gap - work.origin[i + 1]) * rate
    approach = Approach(speed, rate, begun, begun_speed, mass * rate * motion.inertia_rate)
    largest = figures.largest_force
    smallest = minimum(figures.smallest_gap, gap)
    fastest = figures.contact_rate_squared
    if friction.exists() and friction.is_lagged():
        before = Approach(begun_speed, 0.0 * rate, begun, begun_speed, 0.0 * rate)
        if any_true(contact.active(begun, before)):
            _, normal, _ = force_if_acting(contact, begun, before)
            velocity = work.velocity[0, i]
            ratio = friction.ratio(velocity)
            residual[row] += ratio * normal * weight
    near = contact.active(gap, approach)
    if any_true(near):
        _, force, stiffness = force_if_acting(contact, gap, approach)
        force = force * weight
        stiffness = stiffness * weight
        residual[row + 1] -= force
        band[row + 1, 0] += stiffness
        largest = maximum(largest, force)
        fastest = maximum(fastest, contact.bounce_rate_squared(stiffness, mass, speed))
        if friction.exists() and not friction.is_lagged():
            normal = pressing_force(contact, work, slot, force)
            velocity = (work.state[i] - work.origin[i]) * rate
            previous = work.slip[slot]
            ratio = friction.ratio(velocity)
            slope = friction.slope(velocity, previous)
            work.slip[slot] = where(near, velocity, previous)
            # d(drag)/d(gap) is left out: it alone would make the band unsymmetric.
            residual[row] += ratio * normal
            band[row, 0] += normal * slope * rate
    note_contact(contact, work, slot, near)
    return FrameForces(largest, smallest, fastest)
