"""Adaptive steps: by the embedded error estimate, and by the time scale of contact.

An error estimate alone misses resting and chattering contact, so a step is also limited to
``contact_steps`` / (contact frequency sqrt(k/m)) of every node inside the barrier, and repeated
if it came to rest in a barrier that it did not resolve.
"""

from typing import Any, NamedTuple

from snapjump.number.exponentials import exp, log
from snapjump.number.functions import maximum, minimum
from snapjump.stepping.base import (
    accepts,
    first_step,
    newton_tolerance,
    next_step,
    smallest_step,
    step_after_failure,
)

SAFETY = 0.8
GROWTH = 1.5
SHRINKAGE = 0.2
OVERSHOOT = 4.0


class AdaptiveStep(NamedTuple):
    """Error of a step (L), steps a contact time, first, smallest and largest step (T), and
    the share of the tolerance that Newton's method may leave."""

    tolerance: float
    contact_steps: float
    first: float
    smallest: float
    largest: float
    newton_share: float


@first_step.member(AdaptiveStep)
def _first_step(stepping: AdaptiveStep) -> Any:
    return stepping.first


@accepts.member(AdaptiveStep)
def _accepts(stepping: AdaptiveStep, error: Any, step: Any, contact_rate: Any) -> Any:
    resolved = step * contact_rate <= OVERSHOOT * stepping.contact_steps
    return (error <= stepping.tolerance) & resolved


@next_step.member(AdaptiveStep)
def _next_step(
    stepping: AdaptiveStep, error: Any, error_order: Any, step: Any, contact_rate: Any
) -> Any:
    ratio = maximum(error / stepping.tolerance, 1e-12 + 0.0 * error)
    factor = SAFETY * exp(-log(ratio) / error_order)
    factor = minimum(maximum(factor, SHRINKAGE + 0.0 * error), GROWTH + 0.0 * error)
    in_contact = stepping.contact_steps / maximum(contact_rate, 1e-30 + 0.0 * error)
    return minimum(minimum(step * factor, in_contact), stepping.largest + 0.0 * error)


@step_after_failure.member(AdaptiveStep)
def _step_after_failure(stepping: AdaptiveStep, step: Any) -> Any:
    return 0.4 * step


@smallest_step.member(AdaptiveStep)
def _smallest_step(stepping: AdaptiveStep) -> Any:
    return stepping.smallest


@newton_tolerance.member(AdaptiveStep)
def _newton_tolerance(stepping: AdaptiveStep) -> Any:
    return stepping.newton_share * stepping.tolerance
