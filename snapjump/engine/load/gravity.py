"""Weight, on level ground or on a slope: gravity's components across and along the ground."""

from typing import Any, NamedTuple

from snapjump.engine.load.base import Load


@Load.member
class Gravity(NamedTuple):
    """Acceleration (in L/T^2); cosine of the ground's slope, and how far it falls along +x (minus
    its sine); velocity along the ground (in L/T) at which friction holds what rests on it."""

    acceleration: float
    cosine: float = 1.0
    downhill: float = 0.0
    creep_velocity: float = 0.0

    def gravity(self) -> Any:
        return self.acceleration * self.cosine

    def pull(self) -> Any:
        return self.acceleration * self.downhill

    def creep(self) -> Any:
        return self.creep_velocity

    def rise(self, vx: Any, vy: Any) -> Any:
        return vy * self.cosine - vx * self.downhill

    def time_to_apex(self, vx: Any, vy: Any) -> Any:
        return self.rise(vx, vy) / self.acceleration
