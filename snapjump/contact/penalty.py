"""Quadratic penalty: E(d) = k d^2 / 2 for a negative gap d, a spring that is met at d = 0.

Conservative, so that a bounce has restitution 1; the ground is entered by v sqrt(m / k).
"""

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
    elastic_bounce,
    has_contact,
    is_impulsive,
    keeps_open,
)


class Penalty(NamedTuple):
    """Stiffness k (in EI/L^3), the gap (in L) from which on a robot is in the air, weights."""

    stiffness: float
    clearance: float
    node_weight: float
    corner_weight: float


@has_contact.member(Penalty)
def _has_contact(contact: Penalty) -> bool:
    return True


@keeps_open.member(Penalty)
def _keeps_open(contact: Penalty) -> bool:
    return False


@is_impulsive.member(Penalty)
def _is_impulsive(contact: Penalty) -> bool:
    return False


@contact_reach.member(Penalty)
def _reach(contact: Penalty) -> float:
    return 0.0


@clearance.member(Penalty)
def _clearance(contact: Penalty) -> float:
    return contact.clearance


@acts.member(Penalty)
def _acts(contact: Penalty, gap: Any, approach: Any) -> Any:
    return gap < 0.0


@contact_energy.member(Penalty)
def _energy(contact: Penalty, gap: Any) -> Any:
    return 0.5 * contact.stiffness * gap * gap


@contact_force.member(Penalty)
def _force(contact: Penalty, gap: Any, approach: Any) -> Any:
    return -contact.stiffness * gap, contact.stiffness + 0.0 * gap


@contact_loss.member(Penalty)
def _loss(contact: Penalty, gap: Any, approach: Any) -> Any:
    return 0.0 * gap


@contact_weights.member(Penalty)
def _weights(contact: Penalty) -> Any:
    return contact.node_weight, contact.corner_weight


@bounce_rate_squared.member(Penalty)
def _bounce_rate_squared(contact: Penalty, stiffness: Any, mass: Any, speed: Any) -> Any:
    return elastic_bounce(stiffness, mass, speed)
