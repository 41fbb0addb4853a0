"""A fixed step, halved only where Newton's method fails and then grown back."""

from typing import Any, NamedTuple

from snapjump.checks import ParameterError
from snapjump.declare.fields import number
from snapjump.number.functions import minimum
from snapjump.stepping.base import StepControl, SteppingOptions
from snapjump.units import Scales

NEWTON_TOLERANCE_BAR = 1e-9
LARGEST_STEP_BAR = 2.5


class FixedStep(SteppingOptions):
    """One step size throughout, halved only where Newton's method fails."""

    step_s: float = number(1.0e-5, above=0.0, unit="s")

    def check_with(self, simulation: Any) -> None:
        largest_s = LARGEST_STEP_BAR * simulation.robot.scales.time_s
        if self.step_s > largest_s:
            allowed = f"at most {largest_s:.6g} s, {LARGEST_STEP_BAR:g} T of this robot"
            raise ParameterError("stepping.step_s", self.step_s, allowed)

    @StepControl.member
    class Control(NamedTuple):
        """The step (T), and the error that Newton's method may leave (L)."""

        step: float
        newton: float

        def first_step(self) -> Any:
            return self.step

        def accepts(self, error: Any, step: Any, contact_rate: Any) -> Any:
            return step > 0.0

        def next_step(self, error: Any, error_order: Any, step: Any, contact_rate: Any) -> Any:
            return minimum(2.0 * step, self.step + 0.0 * step)

        def step_after_failure(self, step: Any) -> Any:
            return 0.5 * step

        def smallest_step(self) -> Any:
            return 1e-6 * self.step

        def newton_tolerance(self) -> Any:
            return self.newton

    def control(self, scales: Scales) -> Control:
        """The dimensionless control."""
        return self.Control(self.step_s / scales.time_s, NEWTON_TOLERANCE_BAR)
