"""No friction: every friction term is left out of the compiled program."""

from typing import Any, NamedTuple

from snapjump.friction.base import has_friction, holds, is_lagged, slip


class NoFriction(NamedTuple):
    """A perfectly slippery ground."""


@has_friction.member(NoFriction)
def _has_friction(friction: NoFriction) -> bool:
    return False


@is_lagged.member(NoFriction)
def _is_lagged(friction: NoFriction) -> bool:
    return False


@slip.member(NoFriction)
def _slip(friction: NoFriction, velocity: Any, previous: Any) -> Any:
    return 0.0 * velocity, 0.0 * velocity


@holds.member(NoFriction)
def _holds(friction: NoFriction) -> bool:
    return False
