"""Hunt and Crossley (1975): a Hertzian spring whose damping grows with the penetration p.

f = k p^(3/2) (1 + lambda dp/dt) for p = -gap > 0, never pulling: no force at first touch and none
at separation. A mass that enters at speed v leaves at e v, where, for whatever mass, stiffness and
exponent, (1 + e) lambda v = log((1 + lambda v) / (1 - e lambda v)): slower impacts rebound better.
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
from snapjump.number.functions import sqrt, where


class HuntCrossley(NamedTuple):
    """Stiffness k (in EI/L^(7/2)), damping lambda (in T/L), the gap (in L) from which on a robot
    is in the air, weights."""

    stiffness: float
    damping: float
    clearance: float
    node_weight: float
    corner_weight: float


@has_contact.member(HuntCrossley)
def _has_contact(contact: HuntCrossley) -> bool:
    return True


@keeps_open.member(HuntCrossley)
def _keeps_open(contact: HuntCrossley) -> bool:
    return False


@is_impulsive.member(HuntCrossley)
def _is_impulsive(contact: HuntCrossley) -> bool:
    return False


@contact_reach.member(HuntCrossley)
def _reach(contact: HuntCrossley) -> float:
    return 0.0


@clearance.member(HuntCrossley)
def _clearance(contact: HuntCrossley) -> float:
    return contact.clearance


@acts.member(HuntCrossley)
def _acts(contact: HuntCrossley, gap: Any, approach: Any) -> Any:
    return gap < 0.0


@contact_energy.member(HuntCrossley)
def _energy(contact: HuntCrossley, gap: Any) -> Any:
    return 0.4 * contact.stiffness * gap * gap * sqrt(-gap)


@contact_force.member(HuntCrossley)
def _force(contact: HuntCrossley, gap: Any, approach: Any) -> Any:
    root = sqrt(-gap)
    elastic = -contact.stiffness * gap * root
    factor = 1.0 - contact.damping * approach.speed
    slope = 1.5 * contact.stiffness * root * factor + elastic * contact.damping * approach.rate
    pushing = factor > 0.0
    return where(pushing, elastic * factor, 0.0), where(pushing, slope, 0.0)


@contact_loss.member(HuntCrossley)
def _loss(contact: HuntCrossley, gap: Any, approach: Any) -> Any:
    force, _ = _force(contact, gap, approach)
    return (-contact.stiffness * gap * sqrt(-gap) - force) * approach.speed


@contact_weights.member(HuntCrossley)
def _weights(contact: HuntCrossley) -> Any:
    return contact.node_weight, contact.corner_weight


@bounce_rate_squared.member(HuntCrossley)
def _bounce_rate_squared(contact: HuntCrossley, stiffness: Any, mass: Any, speed: Any) -> Any:
    return elastic_bounce(stiffness, mass, speed)
