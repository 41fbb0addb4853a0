"""A fixed step, halved only where Newton's method fails and then grown back."""

from typing import Any, NamedTuple

from snapjump.number.functions import minimum
from snapjump.stepping.base import (
    accepts,
    first_step,
    newton_tolerance,
    next_step,
    smallest_step,
    step_after_failure,
)


class FixedStep(NamedTuple):
    """The step (T), and the error that Newton's method may leave (L)."""

    step: float
    newton: float


@first_step.member(FixedStep)
def _first_step(stepping: FixedStep) -> Any:
    return stepping.step


@accepts.member(FixedStep)
def _accepts(stepping: FixedStep, error: Any, step: Any, contact_rate: Any) -> Any:
    return step > 0.0


@next_step.member(FixedStep)
def _next_step(
    stepping: FixedStep, error: Any, error_order: Any, step: Any, contact_rate: Any
) -> Any:
    return minimum(2.0 * step, stepping.step + 0.0 * step)


@step_after_failure.member(FixedStep)
def _step_after_failure(stepping: FixedStep, step: Any) -> Any:
    return 0.5 * step


@smallest_step.member(FixedStep)
def _smallest_step(stepping: FixedStep) -> Any:
    return 1e-6 * stepping.step


@newton_tolerance.member(FixedStep)
def _newton_tolerance(stepping: FixedStep) -> Any:
    return stepping.newton
