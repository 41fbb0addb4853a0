"""``figure=designs``: inverse design of one robot for many targets, and of many robots."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from experiments.paper.base import Found, Part
from experiments.paper.baseline import TIERS
from experiments.paper.designs import judge, texts
from experiments.paper.designs.cases import GROUPS, METHODS
from experiments.paper.designs.figure import draw_flights, draw_misses
from experiments.paper.learned import shipped_inputs
from experiments.paper.tiers import groups_at
from experiments.paper.unfinished import unfinished
from snapjump.studies.base import Cell, Done, Figure, Row, Section, Table

TITLE = "Inverse designs"
SHOWN = "gauss_newton"  # whose flights the figure has: a design by the forward model alone


class Designs(Part):
    """A cell for each group of targets and each method."""

    name = "designs"
    sources = ("experiments.paper.designs.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """Targets by methods."""
        standard = groups_at(groups, "standard")
        learned = shipped_inputs(standard)
        return [
            Cell(
                f"{group}, {method}",
                {
                    **learned,
                    "groups": standard,
                    "group": group,
                    "method": method,
                    "cases": [list(case) for case in cases],
                    "seed": seed,
                    "tiers": list(TIERS),
                },
            )
            for group, cases in GROUPS.items()
            for method in METHODS
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """Designs of one method."""
        from experiments.paper.designs.compute import design_rows

        return design_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Flights, misses, all designs, one statement."""
        missing = unfinished(TITLE, done)
        if missing:
            return missing
        rows = [
            {"group": one.cell.inputs["group"], "method": one.cell.inputs["method"], **row}
            for one in done.values()
            for row in one.rows
        ]
        shown = {
            group: [row for row in rows if row["group"] == group and row["method"] == SHOWN]
            for group in GROUPS
        }
        misses = {method: [row for row in rows if row["method"] == method] for method in METHODS}
        lines = [judge.line(method, found) for method, found in misses.items()]
        return Found(
            Section(
                TITLE,
                texts.paragraphs(misses),
                {
                    "designs": Figure(texts.CAPTION, partial(draw_flights, shown)),
                    "designs_misses": Figure(texts.MISSES, partial(draw_misses, misses)),
                },
                {
                    "designs_methods": Table("Misses in mm at L = 20 mm", lines),
                    "designs": Table(
                        f"The designs of the figure, by `{SHOWN}`",
                        [judge.design_line(row) for row in rows if row["method"] == SHOWN],
                    ),
                },
            ),
            [judge.millimetres(misses)],
            judge.summary(lines),
        )
