"""Clamps turned at a constant rate from a given angle up to a final one."""

from typing import Any, NamedTuple

from snapjump.drive.base import Programme
from snapjump.drive.parts.turned import time_turned, turned_to
from snapjump.drive.parts.turning import Turning
from snapjump.drive.parts.two_rates import TwoRates


class ConstantRate(Turning):
    """Both clamps turn at a constant rate from the start (the paper's)."""

    differentiable = True

    @Programme.member
    class Law(NamedTuple):
        """Left angle at time 0 and at the end (rad), its rate (rad/T), and how far the right lags
        at time 0."""

        start: float
        end: float
        rate: float
        delta_alpha: float

        def angles(self, time: Any) -> Any:
            return turned_to(self, self.start + self.rate * time, self.rate + 0.0 * time)

        def time_turned(self) -> Any:
            return time_turned(self)

        def initial_share(self) -> Any:
            return 1.0

    @property
    def in_common(self) -> tuple[str, bool]:
        return "right_rate_rad_s given or null, as", self.right_rate_rad_s is not None

    def programme(self, simulation: Any, start: Any) -> Law | TwoRates:
        """The dimensionless programme."""
        numbers = self.numbers(simulation, start)
        if self.right_rate_rad_s is None:
            return self.Law(*numbers)
        return TwoRates(*numbers, self.right_share)
