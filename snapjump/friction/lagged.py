"""Lagged friction: the paper's, with normal force and velocity of the step's beginning.

It is explicit, hence unstable for steps above eps_v m / (mu N).
"""

from typing import Any, NamedTuple

from snapjump.friction.base import has_friction, holds, is_lagged, regularised_sign, slip


class LaggedFriction(NamedTuple):
    """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

    mu: float
    velocity_threshold: float


@has_friction.member(LaggedFriction)
def _has_friction(friction: LaggedFriction) -> bool:
    return True


@is_lagged.member(LaggedFriction)
def _is_lagged(friction: LaggedFriction) -> bool:
    return True


@slip.member(LaggedFriction)
def _slip(friction: LaggedFriction, velocity: Any, previous: Any) -> Any:
    sign, _ = regularised_sign(velocity, friction.velocity_threshold)
    return friction.mu * sign, 0.0 * sign


@holds.member(LaggedFriction)
def _holds(friction: LaggedFriction) -> Any:
    return friction.mu > 0.0
