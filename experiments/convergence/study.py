"""``python run.py task=convergence``: refine one thing at a time, and see what results tend to."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from snapjump.run.studies.base import Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study

from ..compositions import composed, groups_of
from .figures import draw_ladders
from .ladders import OBSERVABLES, Ladder, ladders, observed_row
from .verdict import Verdict, judged

LEVELS = (6, 9)  # quick, full
FEWEST_LEVELS, MOST_LEVELS = 3, 10


class Convergence(Study):
    """Ladders of time, mesh, barrier distance, contact stiffness and friction threshold."""

    options = ("levels",)
    sources = ("experiments.convergence.ladders",)
    scene = "jump"

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """Every level and every reference of every ladder of the configured composition."""
        levels = self.count("levels", LEVELS, FEWEST_LEVELS, MOST_LEVELS)
        groups = groups_of(config)
        composed(groups)
        self.ladders: list[Ladder] = ladders(groups, levels)
        cells = []
        for ladder in self.ladders:
            cells += [Cell(ladder.cell(value), g) for value, g in ladder.levels.items()]
            cells += [Cell(name, g) for name, g in ladder.references.items()]
        return cells

    def compute(self, cell: Cell) -> list[Row]:
        return [observed_row(cell.inputs)]

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        verdicts = [judged(ladder, done, key) for ladder in self.ladders for key in OBSERVABLES]
        base = {k: self.config[k]["name"] for k in ("integrator", "stepping", "discretization")}
        return Conclusion(
            title="Convergence of " + ", ".join(base.values()),
            findings=[finding(ladder, verdicts) for ladder in self.ladders],
            tables={
                "orders": Table(
                    "Observed orders and limits. Errors are in percent of the reference (those "
                    "of x of max(|x|, 0.1 y)): the reference cell of time and nodes, else the "
                    "limit, or the finest level where nothing is approached",
                    [v.row() for v in verdicts],
                    digits={"limit": 8, "reference": 8, "limit_uncertainty": 2},
                ),
                "levels": Table(
                    "Every level and reference",
                    [*map(level_row, done.values())],
                    digits=dict.fromkeys(OBSERVABLES, 7),
                ),
            },
            figures={
                "ladders": Figure(
                    "Error against refinement, with fitted orders",
                    partial(draw_ladders, self.ladders, verdicts),
                )
            },
            summary={
                f"{v.ladder.name}_{v.observable}_{key}": value
                for v in verdicts
                for key, value in (("order", v.fitted), ("limit", v.limit.value))
            },
        )


def level_row(done: Done) -> Row:
    """A line of the table of levels."""
    values = done.rows[0] if done.rows else {"status": f"{done.status}: {done.message}"}
    return {"cell": done.cell.name, **values}


def finding(ladder: Ladder, verdicts: list[Verdict]) -> str:
    """A sentence on the orders that a ladder shows."""
    own = [v for v in verdicts if v.ladder is ladder]
    orders = ", ".join(f"{v.observable} {v.fitted:.2g}" for v in own)
    irregular = [v.observable for v in own if not v.limit.asymptotic]
    promise = "" if ladder.declared is None else f" (declared {ladder.declared:g})"
    text = f"{ladder.name}: observed orders {orders}{promise}."
    if irregular:
        text += f" Not in the asymptotic range: {', '.join(irregular)}."
    judge = own[0].reference_name
    return text + (f" Judged by the cell '{judge}'." if judge else "")
