"""Weight."""

from typing import Any, NamedTuple

from snapjump.load.base import Load


@Load.member
class Gravity(NamedTuple):
    """Downward acceleration (in L/T^2)."""

    acceleration: float

    def gravity(self) -> Any:
        return self.acceleration
