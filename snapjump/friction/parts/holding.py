"""Friction at rest: whatever share of the normal force holds a robot on its slope."""

from typing import Any, NamedTuple

from snapjump.friction.base import FrictionLaw


@FrictionLaw.member
class Holding(NamedTuple):
    """Friction force over normal force."""

    held: float

    def holds(self) -> bool:
        return True

    def ratio(self, velocity: Any) -> Any:
        return self.held + 0.0 * velocity

    def slope(self, velocity: Any, previous: Any) -> Any:
        return 0.0 * velocity
