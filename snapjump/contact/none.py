"""No contact: every contact term is left out of the compiled program."""

from typing import Any, NamedTuple

from snapjump.contact.base import (
    contact_energy,
    contact_force,
    contact_reach,
    contact_weights,
    has_contact,
)


class NoContact(NamedTuple):
    """A world without ground."""


@has_contact.member(NoContact)
def _has_contact(contact: NoContact) -> bool:
    return False


@contact_reach.member(NoContact)
def _reach(contact: NoContact) -> float:
    return 0.0


@contact_energy.member(NoContact)
def _energy(contact: NoContact, gap: Any) -> Any:
    return 0.0 * gap


@contact_force.member(NoContact)
def _force(contact: NoContact, gap: Any) -> Any:
    return 0.0 * gap, 0.0 * gap


@contact_weights.member(NoContact)
def _weights(contact: NoContact) -> Any:
    return 0.0, 0.0
