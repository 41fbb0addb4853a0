"""``figure=imperfections``: the apex of the test design when a parameter is off."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from experiments.paper.base import Found, Part
from experiments.paper.baseline import TIERS
from experiments.paper.imperfections import judge, texts
from experiments.paper.imperfections.changes import changes_of, tangents_of
from experiments.paper.imperfections.figure import draw_errors, draw_lines
from experiments.paper.tiers import groups_at
from experiments.paper.unfinished import unfinished
from snapjump.studies.base import Cell, Done, Figure, Row, Section, Table

TITLE = "Imperfections"
# Every percent, and the ten factors of the released program's test.
FACTORS = np.linspace(0.8, 1.2, 41)
RELEASED = np.linspace(0.8, 1.2, 10)
LINES = ("standard", "reference")
DESIGNS = 64  # a power of two, as Sobol's points ask for
ELSEWHERE = (0.8, 1.2)


class Imperfections(Part):
    """Curves at every tier, exact slopes at two, and other designs."""

    name = "imperfections"
    sources = ("experiments.paper.imperfections.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """Six cells."""
        factors = sorted({round(float(one), 12) for one in (*FACTORS, *RELEASED)})
        at = {tier: groups_at(groups, tier) for tier in TIERS}
        others = {"designs": DESIGNS, "seed": seed, "factors": list(ELSEWHERE)}
        return [
            *(Cell(f"curves, {tier}", {"kind": "curves", "groups": at[tier], "factors": factors})
              for tier in TIERS),
            *(Cell(f"slopes, {tier}", {"kind": "slopes", "groups": at[tier]}) for tier in LINES),
            Cell("elsewhere", {"kind": "elsewhere", "groups": at["standard"], **others}),
        ]  # fmt: skip

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The cell's own kind of rows."""
        from experiments.paper.imperfections.compute import imperfection_rows

        return imperfection_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Errors in the released program's form, straight lines beside them, one statement."""
        missing = unfinished(TITLE, done)
        if missing:
            return missing
        curves = {tier: changes_of(done[f"curves, {tier}"]) for tier in TIERS}
        tangents = {tier: tangents_of(done[f"slopes, {tier}"]) for tier in LINES}
        others = done["elsewhere"].rows
        return Found(
            Section(
                TITLE,
                texts.paragraphs(curves, tangents, others),
                {
                    "imperfections": Figure(
                        texts.CAPTION, partial(draw_errors, curves, RELEASED - 1.0)
                    ),
                    "imperfections_lines": Figure(
                        texts.LINES, partial(draw_lines, curves, tangents["reference"])
                    ),
                },
                {
                    "imperfections": Table(
                        "Errors of up to 20 % at the test design: largest changes of the apex (%)",
                        judge.design_rows(curves),
                    ),
                    "imperfections_slopes": Table(
                        "Elasticities at the test design (% of change for 1 % of error): a line "
                        "fitted to all errors and the secant, at `reference`, and exact tangents",
                        judge.slope_rows(curves["reference"], tangents),
                        digits=dict.fromkeys(judge.slope_rows(curves["reference"], tangents)[0], 3),
                    ),
                    "imperfections_lines": Table(
                        "How far straight lines are off at an error either way, at `reference` (% "
                        "of x or y)",
                        judge.line_rows(curves["reference"], tangents["reference"]),
                    ),
                    "imperfections_elsewhere": Table(
                        f"Errors of 20 % at {DESIGNS} designs spread over the ranges: largest "
                        "change (%)",
                        judge.elsewhere_rows(others),
                    ),
                },
            ),
            [judge.robust(curves, others)],
            judge.summary(curves, tangents),
        )
