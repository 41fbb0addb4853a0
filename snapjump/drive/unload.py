"""A span that opens while the clamps keep their angle: the compression that holds an arch is taken
from it until it snaps."""

from typing import Any, NamedTuple

from snapjump.checks import ParameterError
from snapjump.declare.fields import number
from snapjump.drive.base import ClampAngles, DriveOptions, Programme
from snapjump.number.exponentials import exp
from snapjump.number.functions import where
from snapjump.robot.robot import LARGEST, SMALLEST


class Unload(DriveOptions):
    """The clamps move apart, each at the angle that it has; the arch is at rest in the beginning.

    The span opens from ``design.epsilon`` at a rate that it reaches within about ``rise_time_s``.
    """

    turns = False

    angle_rad: float = number(
        0.6, least=-1.5, most=1.5, unit="rad", doc="angle of the left clamp", symbol="α",
        plan=(0.3, 0.9), kind="control",
    )  # fmt: skip
    rate_m_s: float = number(
        0.1, least=SMALLEST, most=LARGEST, unit="m/s", doc="rate of the span", symbol="v_s",
        plan=(0.01, 1.0), kind="control",
    )  # fmt: skip
    end_epsilon: float = number(
        0.02, least=0.0, most=0.4, doc="pre-compression at which the clamps stop", symbol="ε₁",
        plan=(0.01, 0.05), kind="control",
    )  # fmt: skip
    rise_time_s: float = number(
        1.0e-3, above=0.0, unit="s", doc="time in which the span reaches its rate", symbol="τ_d",
        plan=(1e-4, 1e-2), kind="control",
    )  # fmt: skip

    @Programme.member
    class Law(NamedTuple):
        """Angles of both clamps (rad), the way (L) after which they stop, its rate (L/T) and tau
        (T)."""

        left: float
        right: float
        way: float
        rate: float
        rise_time: float

        def angles(self, time: Any) -> Any:
            missing = 1.0 - exp(-time / self.rise_time)
            moved = self.rate * (time - self.rise_time * missing)
            stopped = moved > self.way
            apart = where(stopped, self.way, moved)
            rate = where(stopped, 0.0, self.rate * missing)
            still = 0.0 * time
            return ClampAngles(self.left + still, self.right + still, still, still, apart, rate)

    def check_with(self, simulation: Any) -> None:
        if self.end_epsilon >= simulation.design.epsilon:
            allowed = f"below design.epsilon = {simulation.design.epsilon:g}, from which it opens"
            raise ParameterError("drive.end_epsilon", self.end_epsilon, allowed)

    def programme(self, simulation: Any, start: Any) -> Law:
        """The dimensionless programme."""
        design, scales = simulation.design, simulation.robot.scales
        return self.Law(
            self.angle_rad,
            self.angle_rad - design.delta_alpha,
            design.epsilon - self.end_epsilon,
            self.rate_m_s / scales.velocity_m_s,
            self.rise_time_s / scales.time_s,
        )

    def rest(self, simulation: Any, arch: Any) -> Any:
        lag = simulation.design.delta_alpha
        flat, turned = (0.0, -lag), (self.angle_rad, self.angle_rad - lag)
        return arch.turn(arch.flat(lag), flat, turned)
