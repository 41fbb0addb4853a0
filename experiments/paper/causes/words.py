"""What words.md says of the paper's choices, filled: which choices it names, and whether it tells
of failures or of slow convergence, depends on the numbers, too much for the part itself."""

from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.run.studies.base import Row

from ...errors import Shift
from ...exchanges import FRAME, PAPER, REFERENCE, START
from ..base import Statement, span
from ..words import Words

WORDS = Words(__file__)
Moved = Mapping[tuple[str, str], Shift]
# Shifts (%) in the median that are seen in the paper's settings, and not in the converged ones.
SEEN_PERCENT, UNSEEN_PERCENT = 1.0, 1.0
# Of a first-order scheme's gain by a shorter step: a strike that gains less is not resolved.
SLOWNESS = 0.5


def moves(one: Shift) -> str:
    """x and y, as a clause."""
    return WORDS("moves", one=one)


def frame(came: str, ladder: Mapping[float, Shift], lost: int, **values: Any) -> Statement:
    """ladder: shifts by how many times stiffer than the beam the frame is; lost: failed jumps in
    the softest; off: of that from reference; epsilon: of the baseline, and what is left of it where
    the motion starts in the softest frame."""
    softest, *others = sorted(ladder)
    stiffer = [{"ratio": ratio, "one": ladder[ratio]} for ratio in others]
    return WORDS.statement(
        "frame",
        came,
        moves=moves(ladder[softest]),
        lost=lost,
        far=" and count as infinitely far" if lost else "",
        stiffer=WORDS.each("frame: a stiffer one", stiffer),
        **values,
    )


def step(came: str, steps: Mapping[float, Shift], **values: Any) -> Statement:
    """steps: shifts from the finest step, by step."""
    own, shortest = max(steps), min(steps)
    last = steps[shortest]
    slowly = steps[own].x_median / last.x_median < SLOWNESS * own / shortest
    others = [{"step_s": s, "one": one} for s, one in steps.items() if s < own]
    return WORDS.statement(
        "step",
        came,
        own_s=own,
        moves=moves(steps[own]),
        others=WORDS.each("step: another", others),
        slowly=" Shorter steps come nearer only slowly." if slowly else "",
        last=last,
        **values,
    )


def stability(came: str, counted: Sequence[Row], barrier_mm: float) -> Statement:
    """By step, the paper's first: failed jumps, all, and the smallest gap."""
    own, *longer = counted
    return WORDS.statement(
        "stability",
        came,
        own=own,
        share=own["smallest_gap_mm"] / barrier_mm,
        longer=WORDS.each("stability: a longer step", longer),
        gaps_mm=span(row["smallest_gap_mm"] for row in counted),
    )


def told(moved: Moved, lost: Sequence[str]) -> dict[str, Any]:
    """What is exchanged, what matters most, and what only seems to; lost: cells with failures."""
    by_end = {
        end: {title: one for (at, title), one in moved.items() if at == end}
        for end in (PAPER, REFERENCE)
    }
    own = by_end[REFERENCE]
    first = sorted(own, key=lambda title: -own[title].x_median)[:4]
    most = WORDS.each("most", ({"title": title, "one": own[title]} for title in first), ", ")
    failures = WORDS("failures", cells="; ".join(lost)) if lost else ""
    return {**by_end, "most": most, "seeming": seeming(moved), "failures": failures}


def seeming(moved: Moved) -> str:
    """What moves x in the paper's settings alone."""
    titles = [
        title
        for title in dict.fromkeys(title for _, title in moved)
        if title not in (START, FRAME)
        and moved[PAPER, title].x_median >= SEEN_PERCENT
        and moved[REFERENCE, title].x_median <= UNSEEN_PERCENT
    ]
    if not titles:
        return WORDS("none seems to matter")
    largest = max(moved[REFERENCE, title].x_median for title in titles)
    return WORDS("some seem to matter", titles=", ".join(titles), largest=largest)
