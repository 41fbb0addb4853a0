"""Logarithmic barrier: the paper's contact law (its eq. for E, the barrier of IPC).

E(d) = -K (d - d_hat)^2 log(d / d_hat) for 0 < d < d_hat, else 0. The energy, its first and its
second derivative vanish at d_hat; the force grows without bound as the gap closes, so that a gap
never becomes negative. The paper prints the bracket of dE/dd; the force is its negative.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import (
    contact_energy,
    contact_force,
    contact_reach,
    contact_weights,
    has_contact,
)
from snapjump.number.functions import log


class LogBarrier(NamedTuple):
    """Barrier stiffness K (in EI/L^3), barrier distance d_hat (in L), and the weights."""

    stiffness: float
    distance: float
    node_weight: float
    corner_weight: float


@has_contact.member(LogBarrier)
def _has_contact(contact: LogBarrier) -> bool:
    return True


@contact_reach.member(LogBarrier)
def _reach(contact: LogBarrier) -> Any:
    return contact.distance


@contact_energy.member(LogBarrier)
def _energy(contact: LogBarrier, gap: Any) -> Any:
    depth = gap - contact.distance
    return -contact.stiffness * depth * depth * log(gap / contact.distance)


@contact_force.member(LogBarrier)
def _force(contact: LogBarrier, gap: Any) -> Any:
    depth = gap - contact.distance
    ratio = depth / gap
    logarithm = log(gap / contact.distance)
    force = contact.stiffness * depth * (2.0 * logarithm + ratio)
    stiffness = contact.stiffness * (ratio * ratio - 4.0 * ratio - 2.0 * logarithm)
    return force, stiffness


@contact_weights.member(LogBarrier)
def _weights(contact: LogBarrier) -> Any:
    return contact.node_weight, contact.corner_weight
