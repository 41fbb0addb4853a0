"""Whether the frame is rigid, the step small enough, and the scheme stable."""

from collections.abc import Mapping, Sequence

import numpy as np

from experiments.paper.causes.shifts import Shift
from experiments.paper.jumps import numbers
from experiments.paper.statement import Statement, verdict
from snapjump.engine.status import NAMES, NO_JUMP, OK
from snapjump.studies.base import Row

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


def failures(rows: Sequence[Row]) -> int:
    """Jumps that did not end as jumps do."""
    return sum(row["status"] not in (NAMES[OK], NAMES[NO_JUMP]) for row in rows)


def stable(rows: Sequence[Row]) -> str:
    """No failures and no closed gap; or few failures, and no closed gap all the same."""
    open_gaps = float(np.nanmin(numbers(rows, "min_gap_m"))) > 0.0
    failed = failures(rows)
    return verdict(open_gaps and failed == 0, open_gaps and failed <= FEW * len(rows))


def frame_statement(
    at_paper: Shift,
    ladder: Mapping[float, Shift],
    epsilon: tuple[float, float],
    accuracy: str,
) -> Statement:
    """ladder: shifts by how many times stiffer than the beam the frame is; epsilon: of the
    baseline, and what is left of it where the motion starts in the softest frame."""
    softest = min(ladder)
    stiffer = "; ".join(
        f"{ratio:,.0f} EI: {one.x_median:.2g} and {one.y_median:.2g} %"
        for ratio, one in ladder.items()
        if ratio > softest
    )
    own = ladder[softest]
    return Statement(
        "A frame of 1000 EI is rigid.",
        matters(own),
        f"Against a rigid frame x_c moves by {own.x_median:.2g} % and y_c by {own.y_median:.2g} % "
        f"in the median, by at most {own.x_p95:.2g} and {own.y_p95:.2g} % in 95 % of the designs "
        f"(with the paper's settings by {at_paper.x_median:.2g} and {at_paper.y_median:.2g} %, "
        f"{at_paper.x_p95:.2g} and {at_paper.y_p95:.2g} %). Stiffer frames tend to the rigid one "
        f"({stiffer}). The beam's thrust pushes the legs apart: before the snap only ε = "
        f"{epsilon[1]:.3f} is left of the baseline's {epsilon[0]:g}, and the clamps turn with the "
        "legs.",
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
        f"A time step of {own:g} s is small enough.",
        matters(found),
        f"Against a step of {finest_s:g} s, all else as in the paper, x_c moves by "
        f"{found.x_median:.2g} % and y_c by {found.y_median:.2g} % in the median, by at most "
        f"{found.x_p95:.2g} and {found.y_p95:.2g} % in 95 % of the designs ({others})."
        + (" Shorter steps come nearer only slowly." if slowly else ""),
        accuracy,
        COMMAND,
    )


def stability_statement(
    jumps: Sequence[Row], coarse: Mapping[float, Sequence[Row]], barrier_m: float
) -> Statement:
    """coarse: jumps of some of the designs with longer steps (s)."""
    gap_m = float(np.nanmin(numbers(jumps, "min_gap_m")))
    longer = "; ".join(
        f"{step:g} s: {failures(rows)} of {len(rows)}, "
        f"{1e3 * np.nanmin(numbers(rows, 'min_gap_m')):.2g} mm"
        for step, rows in coarse.items()
    )
    return Statement(
        "Implicit Euler is stable, and with the logarithmic barrier no gap becomes negative.",
        stable(jumps),
        f"{failures(jumps)} of {len(jumps)} jumps over the paper's ranges fail. The smallest gap "
        f"at the end of any step is {1e3 * gap_m:.2g} mm, {gap_m / barrier_m:.2g} of the "
        f"barrier's distance. With longer steps, which are halved where Newton's "
        f"method fails, failures and smallest gaps: {longer}. Stability says nothing of "
        "accuracy.",
        "the paper's settings",
        COMMAND,
    )
