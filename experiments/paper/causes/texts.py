"""Sentences of the section on causes."""

from collections.abc import Mapping

from experiments.paper.causes.choices import DAMPING, EULER, FRAME, PAPER, REFERENCE, START
from experiments.paper.causes.shifts import Shift

TITLE = "What causes the difference"
Moved = Mapping[tuple[str, str], Shift]
# Shifts (%) in the median that are seen in the paper's settings, and not in the converged ones.
SEEN_PERCENT, UNSEEN_PERCENT = 1.0, 1.0


def paragraphs(moved: Moved, apart: Shift) -> list[str]:
    """What is exchanged, what matters most, and what only seems to."""
    return [
        "The paper's settings and the converged ones differ in several choices. Each is exchanged "
        "alone, once in the paper's settings and once in the converged ones, over the same "
        "designs spread over the paper's ranges. In the converged settings implicit Euler brings "
        "its fixed step along; in the paper's settings the step is made ten times shorter. With "
        "66 elements K per node and per length are the same by definition. Both ends have a rigid "
        "frame; the paper's own is elastic, which comes on top.",
        f"The paper's settings are {apart.x_median:.2g} % off in x_c and {apart.y_median:.2g} % in "
        f"y_c in the median (at most {apart.x_p95:.2g} and {apart.y_p95:.2g} % in 95 % of them). "
        f"Their y_c is {apart.y_signed:+.2g} % from the converged one in the median. Without "
        f"material damping the converged y_c moves by "
        f"{moved[REFERENCE, DAMPING].y_signed:+.2g} %, and with it the paper's by "
        f"{moved[PAPER, DAMPING].y_signed:+.2g} %; the paper's implicit Euler at 1e-5 s, which "
        f"damps what oscillates, moves the converged y_c by "
        f"{moved[REFERENCE, EULER].y_signed:+.2g} %. {most(moved)}",
        noise(moved),
    ]


def most(moved: Moved) -> str:
    """What moves x most in the converged settings."""
    own = {title: one for (end, title), one in moved.items() if end == REFERENCE}
    first = sorted(own, key=lambda title: -own[title].x_median)[:4]
    told = ", ".join(f"{title} ({own[title].x_median:.2g} %)" for title in first)
    return f"In x_c most is moved, put into the converged settings, by {told}."


def noise(moved: Moved) -> str:
    """How much of the shifts in the paper's settings is sensitivity alone."""
    papers, converged = moved[PAPER, START], moved[REFERENCE, START]
    titles = dict.fromkeys(title for _, title in moved)
    seeming = [
        title
        for title in titles
        if title not in (START, FRAME)
        and moved[PAPER, title].x_median >= SEEN_PERCENT
        and moved[REFERENCE, title].x_median <= UNSEEN_PERCENT
    ]
    largest = max((moved[REFERENCE, title].x_median for title in seeming), default=0.0)
    told = (
        f"So do {', '.join(seeming)}: they seem to matter in the paper's settings, and in the "
        f"converged ones they move x_c by at most {largest:.2g} % in the median."
        if seeming
        else "No other choice moves x_c in the paper's settings alone."
    )
    return (
        f"Much of this is noise of a strike that the step does not resolve. A start nearer to the "
        f"snap is the same jump, and moves the converged x_c by {converged.x_median:.1g} %; with "
        f"the paper's settings it moves x_c by {papers.x_median:.2g} % in the median and "
        f"by at most {papers.x_p95:.2g} % in 95 % of the designs. {told}"
    )
