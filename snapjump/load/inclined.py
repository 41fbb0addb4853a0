"""Weight on a slope: gravity's components across and along the ground."""

from typing import Any, NamedTuple

from snapjump.load.base import Load


@Load.member
class InclinedGravity(NamedTuple):
    """Accelerations into the ground and along +x (in L/T^2)."""

    normal: float
    tangential: float

    def gravity(self) -> Any:
        return self.normal

    def pull(self) -> Any:
        return self.tangential
