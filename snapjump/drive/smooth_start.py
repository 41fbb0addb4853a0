"""Clamps that reach their rate smoothly: alpha = rate (t - tau (1 - exp(-t / tau)))."""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.drive.base import Programme
from snapjump.drive.parts.turned import time_turned, turned_to
from snapjump.drive.parts.turning import Turning
from snapjump.number.exponentials import exp


class SmoothStart(Turning):
    """Both clamps start from rest and reach their rate within about ``rise_time_s``."""

    rise_time_s: float = number(
        1.0e-3, above=0.0, unit="s", doc="time in which the clamps reach their rate", symbol="τ_d",
        plan=(1e-4, 1e-2), kind="control", takes_arrays=True,
    )  # fmt: skip

    @Programme.member
    class Law(NamedTuple):
        """Left angle at time 0 and at the end (rad), rate (rad/T), mismatch, the right rate over
        the left one, and tau (T)."""

        start: float
        end: float
        rate: float
        delta_alpha: float
        right_share: float
        rise_time: float

        def has_two_rates(self) -> bool:
            return True

        def right_over_left(self) -> Any:
            return self.right_share

        def angles(self, time: Any) -> Any:
            missing = 1.0 - exp(-time / self.rise_time)
            turned = self.start + self.rate * (time - self.rise_time * missing)
            return turned_to(self, turned, self.rate * missing)

        def time_turned(self) -> Any:
            return time_turned(self)

    @property
    def delay_s(self) -> float:
        return self.rise_time_s

    def programme(self, simulation: Any, start: Any) -> Law:
        """The dimensionless programme."""
        rise = self.rise_time_s / simulation.robot.scales.time_s
        return self.Law(*self.numbers(simulation, start), self.right_share, rise)
