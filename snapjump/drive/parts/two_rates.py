"""Clamps that turn at constant rates of their own."""

from typing import Any, NamedTuple

from snapjump.drive.base import Programme
from snapjump.drive.parts.turned import time_turned, turned_to


@Programme.member
class TwoRates(NamedTuple):
    """Left angle at time 0 and at the end (rad), its rate (rad/T), how far the right lags at time
    0, and the right rate over the left one."""

    start: float
    end: float
    rate: float
    delta_alpha: float
    right_share: float

    def has_two_rates(self) -> bool:
        return True

    def right_over_left(self) -> Any:
        return self.right_share

    def angles(self, time: Any) -> Any:
        return turned_to(self, self.start + self.rate * time, self.rate + 0.0 * time)

    def time_turned(self) -> Any:
        return time_turned(self)

    def initial_share(self) -> Any:
        return 1.0
