"""Clamps that turn at a rate up to an angle."""

import math
from typing import Any

from snapjump.declare.fields import number
from snapjump.drive.base import DriveOptions
from snapjump.robot.robot import LARGEST, SMALLEST


class Turning(DriveOptions):
    """Numbers of clamps that turn at a rate: the left one stops at an angle, and both together."""

    rate_rad_s: float = number(
        20.0, least=SMALLEST, most=LARGEST, unit="rad/s", doc="rate of the clamps", symbol="Ω",
        plan=(5.0, 40.0), kind="control", usual=(1e-4, 1e4), takes_arrays=True,
    )  # fmt: skip
    end_rad: float = number(
        1.5, least=0.0, most=math.pi / 2, unit="rad", doc="angle at which the clamps stop",
        symbol="α₁", plan=(1.3, 1.55), kind="control", takes_arrays=True,
    )  # fmt: skip
    right_rate_rad_s: float | None = number(
        None, least=-LARGEST, most=LARGEST, unit="rad/s",
        doc="rate of the right clamp; null: as the left one", symbol="Ω_r", plan=(0.0, 40.0),
        kind="control", usual=(-1e4, 1e4), takes_arrays=True,
    )  # fmt: skip

    @property
    def right_share(self) -> Any:
        """The right clamp's rate over the left one's."""
        own = self.right_rate_rad_s
        return 1.0 if own is None else own / self.rate_rad_s

    def numbers(self, simulation: Any, start: Any) -> tuple[Any, Any, Any, Any]:
        """start, end, rate and delta_alpha of a programme."""
        rate = self.rate_rad_s * simulation.robot.scales.time_s
        return start, self.end_rad, rate, simulation.design.delta_alpha
