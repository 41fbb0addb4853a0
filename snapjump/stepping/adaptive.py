"""Adaptive steps: by the embedded error estimate, and by the time scale of contact.

An error estimate alone misses resting and chattering contact, so a step is also limited to
``contact_steps`` / (contact frequency sqrt(k/m)) of every node inside the barrier, and repeated
if it came to rest in a barrier that it did not resolve. Where friction may stick, an error over the
step is a sliding velocity: beyond the threshold eps_v it would flip the friction of a foot at rest,
step by step, and so it is held to a few times eps_v.
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.number.exponentials import exp, log
from snapjump.number.functions import maximum, minimum
from snapjump.stepping.base import NEWTON_STICK_SHARE, StepControl, SteppingOptions
from snapjump.units import Scales

SAFETY = 0.8

GROWTH = 1.5

SHRINKAGE = 0.2

OVERSHOOT = 2.0

FIRST_STEP_BAR = 2e-4

SMALLEST_STEP_BAR = 1e-10

LARGEST_STEP_BAR = 0.2

# Steps that resolve no stick zone are none for Newton's method to settle within.
COARSE_STICK_SHARE = 16.0

# Newton's corrections are measured at their largest, errors by their root mean square: a largest
# correction of five tolerances is an error of about one.
NEWTON_SHARE = 5.0

# Beyond this tolerance Newton's corrections, left as large, would close gaps and shake what the
# next step begins with: steps of every size fail.
LOOSEST_NEWTON_BAR = 1e-5


class AdaptiveStep(SteppingOptions):
    """Steps by the embedded error estimate and by the time scale of contact.

    ``tolerance``: error in position a step may make (root mean square over the nodes, in L);
    ``contact_steps``: largest step in units of sqrt(m/k) of a node that bounces in the barrier;
    ``stick_share``: largest error of a step in contact, over the way that eps_v goes in it.
    """

    tolerance: float = number(1e-6, least=1e-12, most=1e-2)
    contact_steps: float = number(2.0, above=0.0)
    stick_share: float = number(8.0, above=0.0)

    @StepControl.member
    class Control(NamedTuple):
        """Error of a step (L), steps a contact time, first, smallest and largest step (T), the
        share of the tolerance that Newton's method may leave, and the error over eps_v h."""

        tolerance: float
        contact_steps: float
        first: float
        smallest: float
        largest: float
        newton_share: float
        stick_share: float

        def first_step(self) -> Any:
            return self.first

        def accepts(self, error: Any, step: Any, contact_rate: Any) -> Any:
            resolved = step * contact_rate <= OVERSHOOT * self.contact_steps
            return (error <= self.tolerance) & resolved

        def stick_factor(self, step: Any, stick_speed: Any) -> Any:
            return self.stick_share * stick_speed * step / self.tolerance

        def newton_stick_share(self) -> Any:
            return NEWTON_STICK_SHARE * max(1.0, self.stick_share / COARSE_STICK_SHARE)

        def next_step(self, error: Any, error_order: Any, step: Any, contact_rate: Any) -> Any:
            ratio = maximum(error / self.tolerance, 1e-12 + 0.0 * error)
            factor = SAFETY * exp(-log(ratio) / error_order)
            factor = minimum(maximum(factor, SHRINKAGE + 0.0 * error), GROWTH + 0.0 * error)
            in_contact = self.contact_steps / maximum(contact_rate, 1e-30 + 0.0 * error)
            return minimum(minimum(step * factor, in_contact), self.largest + 0.0 * error)

        def step_after_failure(self, step: Any) -> Any:
            return 0.4 * step

        def smallest_step(self) -> Any:
            return self.smallest

        def newton_tolerance(self) -> Any:
            return self.newton_share * self.tolerance

        def within(self, smallest: float, largest: float) -> Any:
            return self._replace(smallest=smallest, largest=largest)

    def control(self, scales: Scales) -> Control:
        """The dimensionless control."""
        return self.Control(
            tolerance=self.tolerance,
            contact_steps=self.contact_steps,
            first=FIRST_STEP_BAR,
            smallest=SMALLEST_STEP_BAR,
            largest=LARGEST_STEP_BAR,
            newton_share=NEWTON_SHARE * min(1.0, LOOSEST_NEWTON_BAR / self.tolerance),
            stick_share=self.stick_share,
        )
