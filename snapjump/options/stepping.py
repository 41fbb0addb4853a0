"""Options of the step control."""

from snapjump.declare.fields import Part, number
from snapjump.stepping.adaptive import AdaptiveStep
from snapjump.stepping.fixed import FixedStep
from snapjump.units import Scales

FIRST_STEP_BAR = 2e-4
SMALLEST_STEP_BAR = 1e-10
LARGEST_STEP_BAR = 0.2
# Newton's corrections are measured at their largest, errors by their root mean square: a largest
# correction of five tolerances is an error of about one.
NEWTON_SHARE = 5.0
# Beyond this tolerance Newton's corrections, left as large, would close gaps and shake what the
# next step begins with: steps of every size fail.
LOOSEST_NEWTON_BAR = 1e-5
NEWTON_TOLERANCE_BAR = 1e-9


class SteppingOptions(Part):
    """A step control and its numbers."""

    group = "stepping"


class FixedStepOptions(SteppingOptions):
    """One step size throughout, halved only where Newton's method fails."""

    step_s: float = number(1.0e-5, above=0.0, most=0.01, unit="s")

    def member(self, scales: Scales) -> FixedStep:
        """The dimensionless control."""
        return FixedStep(self.step_s / scales.time_s, NEWTON_TOLERANCE_BAR)


class AdaptiveStepOptions(SteppingOptions):
    """Steps by the embedded error estimate and by the time scale of contact.

    ``tolerance``: error in position a step may make (root mean square over the nodes, in L);
    ``contact_steps``: largest step in units of sqrt(m/k) of a node that bounces in the barrier.
    """

    tolerance: float = number(4.5e-8, least=1e-12, most=1e-2)
    contact_steps: float = number(2.0, above=0.0)

    def member(self, scales: Scales) -> AdaptiveStep:
        """The dimensionless control."""
        return AdaptiveStep(
            tolerance=self.tolerance,
            contact_steps=self.contact_steps,
            first=FIRST_STEP_BAR,
            smallest=SMALLEST_STEP_BAR,
            largest=LARGEST_STEP_BAR,
            newton_share=NEWTON_SHARE * min(1.0, LOOSEST_NEWTON_BAR / self.tolerance),
        )
