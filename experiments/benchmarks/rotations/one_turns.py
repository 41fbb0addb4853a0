"""A programme of the clamps: the left one turns, the right one stays flat."""

from typing import Any, NamedTuple

from snapjump.engine.clamp.base import ClampAngles, ClampProgramme
from snapjump.number.exponentials import exp


@ClampProgramme.member
class OneTurns(NamedTuple):
    """Left angle at time 0 (rad), the rate (rad/T) that it reaches smoothly, and within which time
    tau (T): start + rate (t - tau (1 - exp(-t / tau)))."""

    start: float
    rate: float
    rise_time: float

    def angles(self, time: Any) -> Any:
        missing = 1.0 - exp(-time / self.rise_time)
        left = self.start + self.rate * (time - self.rise_time * missing)
        return ClampAngles(left, 0.0 * left, self.rate * missing, 0.0 * left)
