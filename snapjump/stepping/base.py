"""Step control: the contract that every member fulfils (a ``NamedTuple`` of numbers)."""

from typing import Any

from snapjump.declare.fields import Part
from snapjump.number.methods import Contract, required
from snapjump.units import Scales

NEWTON_STICK_SHARE = 0.1


class StepControl(Contract):
    """Step control: the contract that every member fulfils (a ``NamedTuple`` of numbers)."""

    @required
    def first_step(self) -> Any:
        """Size of the first step (T)."""

    @required
    def accepts(self, error: Any, step: Any, contact_rate: Any) -> Any:
        """Whether a step stands, given its error estimate (L) and the fastest contact frequency."""

    def stick_factor(self, step: Any, stick_speed: Any) -> Any:
        """Largest factor by which a step's error may exceed the tolerance where friction below a
        sliding velocity (L/T) sticks."""
        return 1e30

    def newton_stick_share(self) -> Any:
        """Share of the speed below which friction sticks that Newton's method may leave."""
        return NEWTON_STICK_SHARE

    @required
    def next_step(self, error: Any, error_order: Any, step: Any, contact_rate: Any) -> Any:
        """Size of the next step, or of the repetition of a refused one (T)."""

    @required
    def step_after_failure(self, step: Any) -> Any:
        """Size of the repetition after Newton's method failed (T)."""

    @required
    def smallest_step(self) -> Any:
        """Below this (T) a march ends with the status step_underflow."""

    @required
    def newton_tolerance(self) -> Any:
        """Error (L) that Newton's method may leave in a stage."""

    def within(self, smallest: float, largest: float) -> Any:
        """The same with steps of this range (T), if it is for the control to choose them."""
        return self


class SteppingOptions(Part):
    """A step control and its numbers."""

    group = "stepping"

    @required
    def control(self, scales: Scales) -> Any:
        """The dimensionless control: a member of :class:`StepControl`."""
