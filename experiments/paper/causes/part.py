"""Which of the paper's choices moves the apex by how much."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from experiments.paper.base import Found, Part
from experiments.paper.baseline import BASELINE
from experiments.paper.causes.cells import (
    DESIGNS,
    LONG_STEPS_S,
    RIGID,
    STARTS,
    STEPS_S,
    STIFFNESSES,
    exchange,
    frame,
    many,
    planned,
    step,
)
from experiments.paper.causes.choices import ENDS, FRAME, PAPER, REFERENCE, choices
from experiments.paper.causes.compute import rows_of
from experiments.paper.causes.figure import draw_causes
from experiments.paper.causes.judge import (
    frame_statement,
    stability_statement,
    step_statement,
)
from experiments.paper.causes.shifts import Shift, shift
from experiments.paper.causes.tables import tables
from experiments.paper.causes.texts import TITLE, paragraphs
from experiments.paper.failures import failed
from experiments.paper.unfinished import incomplete, unfinished
from snapjump.studies.base import Cell, Done, Figure, Row, Section


class Causes(Part):
    """The same designs from both ends, with one choice exchanged at a time."""

    name = "causes"
    sources = ("experiments.paper.causes.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Ends, exchanges, frames, steps, and many jumps."""
        return planned(groups, seed)

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """A row for each design."""
        return rows_of(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Three statements, and the table of choices."""
        missing = unfinished(TITLE, done)
        if missing is not None:
            return missing
        rows = {name: one.rows for name, one in done.items()}
        groups = {end: done[end].cell.inputs["groups"] for end in ENDS}
        moved = {
            (end, title): shift(rows[exchange(end, title)], rows[end])
            for end in ENDS
            for title in choices(groups)
        }
        apart = shift(rows[PAPER], rows[REFERENCE])
        ladder = {ratio: shift(rows[frame(ratio)], rows[RIGID]) for ratio in STIFFNESSES}
        soft = rows[frame(STIFFNESSES[0])]
        off = shift(soft, rows[exchange(REFERENCE, FRAME)])
        limit = rows[step(STEPS_S[-1])]
        by_step = {STEPS_S[0]: shift(rows[PAPER], limit)} | {
            s: shift(rows[step(s)], limit) for s in STEPS_S[1:-1]
        }
        figures = {
            "causes": Figure(
                "How far the apex moves when one choice is exchanged: median (mark) to 95 % of "
                f"{DESIGNS} designs (bar)",
                partial(draw_causes, moved, apart),
            )
        }
        statements = [
            frame_statement(
                moved[PAPER, FRAME],
                ladder,
                (BASELINE[1], rows[STARTS][0]["epsilon_left"]),
                (len(failed(soft)), len(soft)),
                f"`standard`, {DESIGNS} designs, against `reference` within {off.x_median:.1g} % "
                f"in x and {off.y_median:.1g} % in y in the median, {off.x_p95:.1g} and "
                f"{off.y_p95:.1g} % in 95 % of them; the paper's settings",
            ),
            step_statement(
                by_step,
                STEPS_S[-1],
                f"the paper's settings, {DESIGNS} designs; the two smallest steps are "
                f"{by_step[STEPS_S[-2]].x_median:.2g} % apart in x and "
                f"{by_step[STEPS_S[-2]].y_median:.2g} % in y",
            ),
            stability_statement(
                rows[many(STEPS_S[0])],
                {s: rows[many(s)] for s in LONG_STEPS_S},
                groups[PAPER]["contact"]["distance_m"],
            ),
        ]
        lost = [incomplete(name, one) for name, one in done.items() if failed(one.rows)]
        texts = paragraphs(moved, apart)
        if lost:
            texts.append(f"Failed jumps count as infinitely far: {'; '.join(lost)}.")
        return Found(
            Section(TITLE, texts, figures, tables(moved, by_step, rows)),
            statements,
            summary(apart, ladder[STIFFNESSES[0]], by_step[STEPS_S[0]]),
        )


def summary(apart: Shift, framed: Shift, stepped: Shift) -> dict[str, float]:
    """Flat numbers."""
    named = {"paper_to_reference": apart, "frame_1000_ei": framed, "step_1e_5_s": stepped}
    return {
        f"{name}_{key}_median_percent": getattr(found, f"{key}_median")
        for name, found in named.items()
        for key in ("x", "y")
    }
