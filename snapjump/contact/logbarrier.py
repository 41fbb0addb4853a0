"""Logarithmic barrier: the paper's contact law (its eq. for E, the barrier of IPC).

E(d) = -K (d - d_hat)^2 log(d / d_hat) for 0 < d < d_hat, else 0. The energy, its first and its
second derivative vanish at d_hat; the force grows without bound as the gap closes, so that a gap
never becomes negative. The paper prints the bracket of dE/dd; the force is its negative.

Damping, if any, adds a viscous share of the stiffness: force - eta E''(d) d(d)/dt, never pulling.
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
from snapjump.number.dispatch import kernel
from snapjump.number.exponentials import log
from snapjump.number.functions import where


class LogBarrier(NamedTuple):
    """Barrier stiffness K (in EI/L^3), distance d_hat (in L), relaxation time (in T), weights."""

    stiffness: float
    distance: float
    relaxation_time: float
    node_weight: float
    corner_weight: float


@has_contact.member(LogBarrier)
def _has_contact(contact: LogBarrier) -> bool:
    return True


@keeps_open.member(LogBarrier)
def _keeps_open(contact: LogBarrier) -> bool:
    return True


@is_impulsive.member(LogBarrier)
def _is_impulsive(contact: LogBarrier) -> bool:
    return False


@contact_reach.member(LogBarrier)
def _reach(contact: LogBarrier) -> Any:
    return contact.distance


@clearance.member(LogBarrier)
def _clearance(contact: LogBarrier) -> Any:
    return contact.distance


@acts.member(LogBarrier)
def _acts(contact: LogBarrier, gap: Any, approach: Any) -> Any:
    return gap < contact.distance


@contact_energy.member(LogBarrier)
def _energy(contact: LogBarrier, gap: Any) -> Any:
    depth = gap - contact.distance
    return -contact.stiffness * depth * depth * log(gap / contact.distance)


@kernel
def barrier(contact: LogBarrier, gap: Any) -> Any:
    """Elastic force, its negative derivative by the gap, and the derivative of that."""
    depth = gap - contact.distance
    ratio = depth / gap
    logarithm = log(gap / contact.distance)
    force = contact.stiffness * depth * (2.0 * logarithm + ratio)
    stiffness = contact.stiffness * (ratio * ratio - 4.0 * ratio - 2.0 * logarithm)
    sharpening = 2.0 * contact.stiffness * ((ratio - 2.0) * (1.0 - ratio) - 1.0) / gap
    return force, stiffness, sharpening


@contact_force.member(LogBarrier)
def _force(contact: LogBarrier, gap: Any, approach: Any) -> Any:
    force, stiffness, sharpening = barrier(contact, gap)
    lag = contact.relaxation_time
    total = force - lag * stiffness * approach.speed
    slope = stiffness + lag * (stiffness * approach.rate + sharpening * approach.speed)
    pushing = total > 0.0
    return where(pushing, total, 0.0), where(pushing, slope, 0.0)


@contact_loss.member(LogBarrier)
def _loss(contact: LogBarrier, gap: Any, approach: Any) -> Any:
    elastic, _, _ = barrier(contact, gap)
    force, _ = _force(contact, gap, approach)
    return (elastic - force) * approach.speed


@contact_weights.member(LogBarrier)
def _weights(contact: LogBarrier) -> Any:
    return contact.node_weight, contact.corner_weight


@bounce_rate_squared.member(LogBarrier)
def _bounce_rate_squared(contact: LogBarrier, stiffness: Any, mass: Any, speed: Any) -> Any:
    return elastic_bounce(stiffness, mass, speed)
