"""Normal contact with the ground, y = 0: the contract that every contact law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers. Lengths are in L, forces in EI/L^2.
"""

from typing import Any

from snapjump.number.dispatch import family_function, kernel
from snapjump.number.functions import minimum

# Slower than this (in L/T) a contact rests: what an unresolved bounce could lose is then nothing.
RESTING_SPEED = 0.02


@family_function
def contact_reach(contact: Any) -> Any:
    """The gap beyond which the law gives no force (0 for no contact at all)."""


@family_function
def contact_energy(contact: Any, gap: Any) -> Any:
    """Energy stored at a gap within reach, before the weight."""


@family_function
def contact_force(contact: Any, gap: Any) -> Any:
    """Repulsive force -dE/dgap and stiffness d2E/dgap2 at a gap within reach, before the weight."""


@family_function
def contact_weights(contact: Any) -> Any:
    """Factors of the force at a node of the beam and at a corner of the frame."""


@family_function
def has_contact(contact: Any) -> Any:
    """Whether contact terms are compiled in."""


@kernel
def bounce_rate_squared(stiffness: Any, mass: Any, speed: Any) -> Any:
    """Square of the frequency (1/T^2) that steps must resolve: k/m, less where contact rests."""
    pace = speed / RESTING_SPEED
    return stiffness / mass * minimum(pace * pace, 1.0 + 0.0 * pace)
