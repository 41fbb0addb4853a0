"""Whether the frame is rigid, the step small enough, and the scheme stable."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from experiments.errors import percentile, relative_errors
from experiments.paper.base import failed
from experiments.paper.jumps import numbers
from experiments.paper.statement import Statement, verdict
from snapjump.run.studies.base import Row


@dataclass(frozen=True)
class Shift:
    """Medians and 95th percentiles of the shift (%), x relative to max(|x|, 0.1 y); ``y_signed``:
    the median with its sign. A jump that failed counts as infinitely far."""

    x_median: float
    x_p95: float
    y_median: float
    y_p95: float
    y_signed: float

    @property
    def medians(self) -> float:
        """The larger median."""
        return max(self.x_median, self.y_median)

    @property
    def p95(self) -> float:
        """The larger 95th percentile."""
        return max(self.x_p95, self.y_p95)


def shift(rows: Sequence[Row], base: Sequence[Row]) -> Shift:
    """The shift from the base."""
    x, y, x0, y0 = (numbers(r, key) for r in (rows, base) for key in ("x_bar", "y_bar"))
    in_x, in_y = relative_errors(x, y, x0, y0)
    return Shift(
        percentile(in_x, 50.0),
        percentile(in_x, 95.0),
        percentile(in_y, 50.0),
        percentile(in_y, 95.0),
        float(np.nanmedian(100.0 * (y / y0 - 1.0))),
    )


# Shifts (%): of 95 % of the designs, below which a choice does not matter; and of half of them,
# above which it does, whatever is concluded from the jumps.
NEGLIGIBLE_PERCENT, SMALL_PERCENT = 1.0, 5.0
# Of jumps that may fail before a scheme is called unstable.
FEW = 0.01
# Of a first-order scheme's gain by a shorter step: a strike that gains less is not resolved.
SLOWNESS = 0.5
COMMAND = "task=paper figure=causes"


def matters(found: Shift) -> str:
    """The verdict on a choice that is said not to matter."""
    return verdict(found.p95 <= NEGLIGIBLE_PERCENT, found.medians <= SMALL_PERCENT)


def stable(rows: Sequence[Row]) -> str:
    """No failures; or few. The gaps do not count: the scheme cannot close them."""
    lost = len(failed(rows))
    return verdict(lost == 0, lost <= FEW * len(rows))


def frame_statement(
    at_paper: Shift,
    ladder: Mapping[float, Shift],
    epsilon: tuple[float, float],
    lost: tuple[int, int],
    accuracy: str,
) -> Statement:
    """ladder: shifts by how many times stiffer than the beam the frame is; epsilon: of the
    baseline, and what is left of it where the motion starts in the softest frame; lost: failed
    jumps in the softest frame, and all."""
    softest = min(ladder)
    stiffer = "; ".join(
        f"{one.x_median:.2g} and {one.y_median:.2g} % ({ratio:,.0f} EI)"
        for ratio, one in ladder.items()
        if ratio > softest
    )
    own = ladder[softest]
    return Statement(
        "A frame of 1000 EI is rigid (our reading)",
        matters(own),
        f"Against a rigid frame x_c moves by {own.x_median:.2g} % and y_c by {own.y_median:.2g} % "
        f"in the median, by at most {own.x_p95:.2g} and {own.y_p95:.2g} % in 95 % of the designs "
        f"(with the paper's settings by {at_paper.x_median:.2g} and {at_paper.y_median:.2g} %, "
        f"{at_paper.x_p95:.2g} and {at_paper.y_p95:.2g} %). "
        f"{lost[0]} of {lost[1]} jumps fail"
        + (" and count as infinitely far" if lost[0] else "")
        + f". With stiffer frames the medians are {stiffer}. The beam's thrust pushes the legs "
        f"apart: before the snap only ε = {epsilon[1]:.3f} is left of the baseline's "
        f"{epsilon[0]:g}, and the clamps turn with the legs.",
        accuracy,
        COMMAND,
    )


def step_statement(steps: Mapping[float, Shift], finest_s: float, accuracy: str) -> Statement:
    """steps: shifts from the finest step, by step (s)."""
    own = max(steps)
    found = steps[own]
    shortest = min(steps)
    slowly = found.x_median / steps[shortest].x_median < SLOWNESS * own / shortest
    others = "; ".join(
        f"{step:g} s: {one.x_median:.2g} and {one.y_median:.2g} %"
        for step, one in steps.items()
        if step < own
    )
    return Statement(
        f"A time step of {own:g} s is small enough (our reading)",
        matters(found),
        f"Against a step of {finest_s:g} s, all else as in the paper, x_c moves by "
        f"{found.x_median:.2g} % and y_c by {found.y_median:.2g} % in the median, by at most "
        f"{found.x_p95:.2g} and {found.y_p95:.2g} % in 95 % of the designs ({others})."
        + (" Shorter steps come nearer only slowly." if slowly else "")
        + f" The limit itself is no better known than the two smallest steps agree: to "
        f"{steps[shortest].x_median:.2g} % in x_c and {steps[shortest].y_median:.2g} % in y_c.",
        accuracy,
        COMMAND,
    )


def stability_statement(
    jumps: Sequence[Row], coarse: Mapping[float, Sequence[Row]], barrier_m: float
) -> Statement:
    """coarse: jumps of some of the designs with longer steps (s)."""
    gaps = [float(np.nanmin(numbers(rows, "min_gap_m"))) for rows in (jumps, *coarse.values())]
    gap_m = gaps[0]
    longer = "; ".join(
        f"{step:g} s: {len(failed(rows))} of {len(rows)}, "
        f"{1e3 * np.nanmin(numbers(rows, 'min_gap_m')):.2g} mm"
        for step, rows in coarse.items()
    )
    return Statement(
        "Implicit Euler is stable, and with the logarithmic barrier no gap becomes negative (our "
        "reading)",
        stable(jumps),
        f"{len(failed(jumps))} of {len(jumps)} jumps over the paper's ranges fail. The smallest "
        f"gap at the end of any step is {1e3 * gap_m:.2g} mm, {gap_m / barrier_m:.2g} of the "
        f"barrier's distance. That none closes is no finding: Newton's steps are limited so that "
        f"no gap can, and failures alone are judged. With longer steps, which are halved where "
        f"Newton's method fails, failures and smallest gaps: {longer}. Stability says nothing of "
        "accuracy.",
        f"the paper's settings; smallest gaps at all steps {1e3 * min(gaps):.2g} to "
        f"{1e3 * max(gaps):.2g} mm",
        COMMAND,
    )
