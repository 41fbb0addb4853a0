"""Normal contact with the ground, y = 0: the contract that every contact law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers. Lengths are in L, forces in EI/L^2.
"""

from typing import Any, NamedTuple

from snapjump.number.dispatch import family_function, kernel
from snapjump.number.functions import minimum, where

# Slower than this (in L/T) a contact rests: what an unresolved bounce could lose is then nothing.
RESTING_SPEED = 0.02


class Approach(NamedTuple):
    """How a point comes near the ground within a stage.

    speed: of its gap (L/T); rate: d(speed)/d(gap), 0 in statics (1/T); begun, begun_speed: gap
    and speed at the step's beginning; inertia: d(inertial force)/d(gap) (EI/L^3).
    """

    speed: Any
    rate: Any
    begun: Any
    begun_speed: Any
    inertia: Any


@family_function
def has_contact(contact: Any) -> Any:
    """Whether contact terms are compiled in."""


@family_function
def keeps_open(contact: Any) -> Any:
    """Whether the law needs positive gaps, which every correction must then leave."""


@family_function
def is_impulsive(contact: Any) -> Any:
    """Whether the force is that which a constraint calls for, rather than one of the position."""


@family_function
def contact_reach(contact: Any) -> Any:
    """The gap beyond which the law gives no force at rest (0 for no contact at all)."""


@family_function
def clearance(contact: Any) -> Any:
    """The gap beyond which a point counts as in the air."""


@family_function
def acts(contact: Any, gap: Any, approach: Any) -> Any:
    """Mask: whether the law gives a force. Only then is :func:`contact_force` asked for it."""


@family_function
def contact_energy(contact: Any, gap: Any) -> Any:
    """Energy stored at a gap within reach, before the weight."""


@family_function
def contact_force(contact: Any, gap: Any, approach: Any) -> Any:
    """Repulsive force and its negative total derivative by the gap, before the weight."""


@family_function
def contact_loss(contact: Any, gap: Any, approach: Any) -> Any:
    """Power that the law takes out, before the weight (EI/(L T))."""


@family_function
def contact_weights(contact: Any) -> Any:
    """Factors of the force at a node of the beam and at a corner of the frame."""


@family_function
def bounce_rate_squared(contact: Any, stiffness: Any, mass: Any, speed: Any) -> Any:
    """Square of the frequency (1/T^2) that steps must resolve where a mass is in contact."""


@kernel
def elastic_bounce(stiffness: Any, mass: Any, speed: Any) -> Any:
    """k/m, less where contact rests."""
    pace = speed / RESTING_SPEED
    return stiffness / mass * minimum(pace * pace, 1.0 + 0.0 * pace)


@kernel
def at_rest(gap: Any) -> Approach:
    """The approach of a point that does not move."""
    zero = 0.0 * gap
    return Approach(zero, zero, gap, zero, zero)


@kernel
def force_if_acting(contact: Any, gap: Any, approach: Any) -> Any:
    """Mask, force and stiffness, the latter two zero where the law does not act."""
    active = acts(contact, gap, approach)
    # A barrier has no force beyond its reach, and no value below zero.
    force, stiffness = contact_force(contact, where(active, gap, contact_reach(contact)), approach)
    return active, where(active, force, 0.0), where(active, stiffness, 0.0)


@kernel
def pressing_force(contact: Any, work: Any, point: Any, force: Any) -> Any:
    """The normal force that friction sees at a point that the law acts on.

    That of a constraint is known only once an iteration has held the point in its place.
    """
    if is_impulsive(contact):
        return where(work.held[point] > 0.0, force, 0.0)
    return force


@kernel
def note_contact(contact: Any, work: Any, point: Any, near: Any) -> None:
    """Remember which points a constraint holds in this iteration."""
    if is_impulsive(contact):
        work.held[point] = where(near, 1.0, 0.0)
