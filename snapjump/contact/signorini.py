"""Signorini's condition with Newton's impact law: the rigid ground.

Gap and force exclude each other, 0 <= gap - target _|_ force >= 0. At a step's end the target is
the ground; where the gap would close within the step at the speed it has, it is the place that the
rebound velocity -e v leads to, gap_0 - h e v (Moreau 1988, Jean 1999: an impact law of velocities,
which implicit Euler turns into one of positions). The complementarity function
force - max(0, force_0 + r (target - gap)) is solved by a non-smooth Newton method with force_0 = 0
and r far above the inertia: the gap misses its target by a millionth of a step's travel.

A skin of a few nanometres keeps that miss from making a gap negative.
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
    has_contact,
    is_impulsive,
    keeps_open,
)
from snapjump.number.dispatch import kernel
from snapjump.number.functions import maximum, where

STIFFER_THAN_INERTIA = 1e6
STATIC_STIFFNESS = 1e8  # EI/L^3
SKIN = 1e-6  # L


class Signorini(NamedTuple):
    """Restitution e, and the gap (in L) from which on a robot is in the air."""

    restitution: float
    clearance: float


@has_contact.member(Signorini)
def _has_contact(contact: Signorini) -> bool:
    return True


@keeps_open.member(Signorini)
def _keeps_open(contact: Signorini) -> bool:
    return False


@is_impulsive.member(Signorini)
def _is_impulsive(contact: Signorini) -> bool:
    return True


@contact_reach.member(Signorini)
def _reach(contact: Signorini) -> float:
    return SKIN


@clearance.member(Signorini)
def _clearance(contact: Signorini) -> float:
    return contact.clearance


@kernel
def target_gap(contact: Signorini, approach: Any) -> Any:
    """The gap that the step must not end below."""
    rate = approach.rate
    step = where(rate > 0.0, 1.0 / maximum(rate, 1e-300 + 0.0 * rate), 0.0)
    closing = approach.begun + step * approach.begun_speed < SKIN
    falling = approach.begun_speed < 0.0
    rebound = approach.begun - contact.restitution * step * approach.begun_speed
    return where(closing & falling & (rebound > SKIN), rebound, SKIN)


@acts.member(Signorini)
def _acts(contact: Signorini, gap: Any, approach: Any) -> Any:
    return gap < target_gap(contact, approach)


@contact_energy.member(Signorini)
def _energy(contact: Signorini, gap: Any) -> Any:
    return 0.0 * gap


@contact_force.member(Signorini)
def _force(contact: Signorini, gap: Any, approach: Any) -> Any:
    stiffness = STATIC_STIFFNESS + STIFFER_THAN_INERTIA * approach.inertia
    return stiffness * (target_gap(contact, approach) - gap), stiffness


@contact_loss.member(Signorini)
def _loss(contact: Signorini, gap: Any, approach: Any) -> Any:
    # A constant force over the step, along which the speed jumps.
    force, _ = _force(contact, gap, approach)
    return -0.5 * force * (approach.speed + approach.begun_speed)


@contact_weights.member(Signorini)
def _weights(contact: Signorini) -> Any:
    return 1.0, 1.0


@bounce_rate_squared.member(Signorini)
def _bounce_rate_squared(contact: Signorini, stiffness: Any, mass: Any, speed: Any) -> Any:
    return 0.0 * speed
