"""No friction: every friction term is left out of the compiled program."""

from typing import Any, NamedTuple

from snapjump.friction.base import FrictionLaw


@FrictionLaw.member
class NoFriction(NamedTuple):
    """A perfectly slippery ground."""

    def exists(self) -> bool:
        return False

    def holds(self) -> bool:
        return False

    def ratio(self, velocity: Any) -> Any:
        return 0.0 * velocity

    def slope(self, velocity: Any, previous: Any) -> Any:
        return 0.0 * velocity
