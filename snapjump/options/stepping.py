"""Options of the step control."""

from dataclasses import dataclass

from snapjump.checks import check_number
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


@dataclass(frozen=True)
class FixedStepOptions:
    """One step size throughout, halved only where Newton's method fails."""

    step_s: float = 1.0e-5

    def __post_init__(self) -> None:
        check_number("stepping.step_s", self.step_s, 0.0, 0.01, above=True, unit="s")

    def member(self, scales: Scales) -> FixedStep:
        """The dimensionless control."""
        return FixedStep(self.step_s / scales.time_s, NEWTON_TOLERANCE_BAR)


@dataclass(frozen=True)
class AdaptiveStepOptions:
    """Steps by the embedded error estimate and by the time scale of contact.

    ``tolerance``: error in position a step may make (root mean square over the nodes, in L);
    ``contact_steps``: largest step in units of sqrt(m/k) of a node that bounces in the barrier.
    """

    tolerance: float = 4.5e-8
    contact_steps: float = 2.0

    def __post_init__(self) -> None:
        check_number("stepping.tolerance", self.tolerance, 1e-12, 1e-2)
        check_number("stepping.contact_steps", self.contact_steps, 0.0, above=True)

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
