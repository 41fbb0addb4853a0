"""Friction against the ground: the contract that every friction law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers. Forces are in EI/L^2, velocities in L/T.
"""

from typing import Any

from snapjump.number.dispatch import family_function, kernel
from snapjump.number.functions import absolute, where


@family_function
def has_friction(friction: Any) -> Any:
    """Whether friction terms are compiled in."""


@family_function
def is_lagged(friction: Any) -> Any:
    """Whether normal force and velocity are those of the step's beginning."""


@family_function
def holds(friction: Any) -> Any:
    """Whether friction keeps a resting robot in its place (a mask)."""


@family_function
def slip(friction: Any, velocity: Any, previous: Any) -> Any:
    """Friction force over normal force, and its derivative with respect to the velocity.

    ``previous`` is the velocity at the Newton iterate before: a law may use it to linearise
    safely where its derivative jumps.
    """


@kernel
def regularised_sign(velocity: Any, threshold: Any) -> Any:
    """Smoothed sign of the velocity and its slope: 2 v/e - v|v|/e^2 for |v| < e.

    The factor 2, missing in the paper's print, makes it continuously differentiable at |v| = e.
    """
    w = velocity / threshold
    size = absolute(w)
    slipping = size >= 1.0
    sign = where(slipping, where(w > 0.0, 1.0, -1.0), w * (2.0 - size))
    slope = where(slipping, 0.0, (2.0 - 2.0 * size) / threshold)
    return sign, slope
