"""No contact: every contact term is left out of the compiled program."""

from typing import Any, NamedTuple

from snapjump.contact.base import (
    acts,
    bounce_rate_squared,
    clearance,
    contact_energy,
    contact_force,
    contact_loss,
    contact_reach,
    contact_weights,
    has_contact,
    is_impulsive,
    keeps_open,
)


class NoContact(NamedTuple):
    """A world without ground."""


@has_contact.member(NoContact)
def _has_contact(contact: NoContact) -> bool:
    return False


@keeps_open.member(NoContact)
def _keeps_open(contact: NoContact) -> bool:
    return False


@is_impulsive.member(NoContact)
def _is_impulsive(contact: NoContact) -> bool:
    return False


@contact_reach.member(NoContact)
def _reach(contact: NoContact) -> float:
    return 0.0


@clearance.member(NoContact)
def _clearance(contact: NoContact) -> float:
    return 0.0


@acts.member(NoContact)
def _acts(contact: NoContact, gap: Any, approach: Any) -> Any:
    return gap < -1.0e300


@contact_energy.member(NoContact)
def _energy(contact: NoContact, gap: Any) -> Any:
    return 0.0 * gap


@contact_force.member(NoContact)
def _force(contact: NoContact, gap: Any, approach: Any) -> Any:
    return 0.0 * gap, 0.0 * gap


@contact_loss.member(NoContact)
def _loss(contact: NoContact, gap: Any, approach: Any) -> Any:
    return 0.0 * gap


@contact_weights.member(NoContact)
def _weights(contact: NoContact) -> Any:
    return 0.0, 0.0


@bounce_rate_squared.member(NoContact)
def _bounce_rate_squared(contact: NoContact, stiffness: Any, mass: Any, speed: Any) -> Any:
    return 0.0 * speed
