"""Implicit friction: normal force and velocity are the unknown ones of the stage."""

from typing import Any, NamedTuple

from snapjump.friction.base import has_friction, holds, is_lagged, regularised_sign, slip
from snapjump.number.functions import where


class ImplicitFriction(NamedTuple):
    """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

    mu: float
    velocity_threshold: float


@has_friction.member(ImplicitFriction)
def _has_friction(friction: ImplicitFriction) -> bool:
    return True


@is_lagged.member(ImplicitFriction)
def _is_lagged(friction: ImplicitFriction) -> bool:
    return False


@slip.member(ImplicitFriction)
def _slip(friction: ImplicitFriction, velocity: Any, previous: Any) -> Any:
    sign, slope = regularised_sign(velocity, friction.velocity_threshold)
    # Newton would jump to and fro across the stick zone: after a change of sign, use the slope
    # at rest, the steepest there is.
    slope = where(velocity * previous < 0.0, 2.0 / friction.velocity_threshold, slope)
    return friction.mu * sign, friction.mu * slope


@holds.member(ImplicitFriction)
def _holds(friction: ImplicitFriction) -> Any:
    return friction.mu > 0.0
