"""A jump of the source's mass and length, and what is not known of its robot."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column

from ...compositions import changed, groups_at
from ...paper.words import Words
from ..arches import WITHOUT_DRAG
from ..base import Compared, Comparison, Source, percent_off
from .figure import draw_heights
from .jumps import AIR_KG_M3, COEFFICIENT, band_rows, height_rows, single_rows

MASS_KG = 1.6e-3
GRAVITY_M_S2, PAPERS_M_S2 = 9.81, 10.0
EPSILONS = tuple(round(0.1 + 0.02 * k, 2) for k in range(11))
MIDDLE = 0.2
COUNT = 256
BAND = (5.0, 95.0)  # percent of the robots
HEIGHTS, PAPERS, UNKNOWNS, SINGLE, DRAG = "heights", "g = 10", "unknowns", "single", "drag"


class Cascade(Source):
    """Heights over pre-compression, and of many robots of that mass."""

    name = "cascade"
    words = Words(__file__)
    kinds = {"heights": height_rows, "band": band_rows, "single": single_rows}
    every_jump = True

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Those with the gravity of experiments, one with the paper's, and one with drag."""
        standard = groups_at(groups, "standard")
        equal = {"design": {"epsilon": MIDDLE, "delta_alpha": 0.0}}
        made = changed(standard, {**WITHOUT_DRAG, **equal, "robot": {"gravity_m_s2": GRAVITY_M_S2}})
        own = {"mass_kg": MASS_KG}

        def cell(name: str, kind: str, changes: Any = None, **values: Any) -> Cell:
            return Cell(
                name, {"kind": kind, "groups": changed(made, changes or {}), **own, **values}
            )

        air = {"name": "quadratic", "coefficient": COEFFICIENT, "air_density_kg_m3": AIR_KG_M3}
        return [
            cell(HEIGHTS, "heights", epsilons=EPSILONS),
            cell(PAPERS, "heights", {"robot": {"gravity_m_s2": PAPERS_M_S2}}, epsilons=[MIDDLE]),
            cell(UNKNOWNS, "band", count=COUNT, seed=seed),
            cell(SINGLE, "single"),
            cell(DRAG, "heights", {"drag": air}, epsilons=[MIDDLE]),
        ]

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Height, and the band."""
        rows, band = done[HEIGHTS].rows, done[UNKNOWNS].rows
        ends = percentiles(band, "height_m", BAND)
        comparisons = [*self.heights(rows, done), self.band(band, ends)]
        unknowns = [
            {key: row[key] for key in ("unknown", "value", "height_m", "with_drag_m")}
            for row in done[SINGLE].rows
        ]
        draw = partial(draw_heights, rows, band, ends, self.number("height"))
        section = self.section(
            comparisons, {"cascade": draw},
            {"cascade_heights": rows, "cascade_unknowns": unknowns},
            coefficient=COEFFICIENT, air=AIR_KG_M3,
        )  # fmt: skip
        middle = row_at(rows, MIDDLE)
        summary = {"cascade_height_m": middle["height_m"],
                   "cascade_height_with_drag_m": middle["with_drag_m"]}  # fmt: skip
        return Compared(section, [], summary, comparisons)

    def heights(self, rows: Sequence[Row], done: Mapping[str, Done]) -> list[Comparison]:
        """The rows of the height."""
        middle = row_at(rows, MIDDLE)
        height, drag = column(rows, "height_m"), column(rows, "with_drag_m")
        off = percent_off(middle["height_m"], self.number("height"))
        length_m = done[HEIGHTS].cell.inputs["groups"]["robot"]["length_m"]
        lengths = middle["height_m"] / length_m
        lengths_off = percent_off(lengths, self.number("lengths"))
        return [
            self.compared(
                "height", f"{middle['height_m']:.3f}", f"{off:.2g} %", self.by_limit("height", off),
                epsilon=MIDDLE, drag=middle["with_drag_m"],
                simulated=done[DRAG].rows[0]["height_m"],
                least=EPSILONS[0], most=EPSILONS[-1], low=height.min(), high=height.max(),
                low_drag=drag.min(), high_drag=drag.max(), gravity=GRAVITY_M_S2,
                ten=done[PAPERS].rows[0]["height_m"],
            ),
            self.compared(
                "lengths", f"{lengths:.1f}", f"{lengths_off:.2g} %",
                self.by_limit("height", lengths_off), quotient=self.number("height") / length_m,
            ),
        ]  # fmt: skip

    def band(self, rows: Sequence[Row], ends: tuple[float, float]) -> Comparison:
        """The row of the band."""
        theirs = self.number("band")
        low, high = ends
        outside = 100.0 * max(low - theirs, theirs - high, 0.0) / theirs
        low_drag, high_drag = percentiles(rows, "with_drag_m", BAND)
        return self.compared(
            "band", f"{low:.2f} to {high:.2f}", f"{outside:.2g} % outside",
            self.by_limit("band", outside), count=len(rows), low_drag=low_drag,
            high_drag=high_drag, median=float(np.median(column(rows, "height_m"))),
        )  # fmt: skip


def row_at(rows: Sequence[Row], epsilon: float) -> Row:
    """The row of a pre-compression."""
    return next(row for row in rows if row["design.epsilon"] == epsilon)


def percentiles(rows: Sequence[Row], key: str, shares: tuple[float, float]) -> tuple[float, float]:
    """Of a column, at two shares (%)."""
    low, high = np.percentile(column(rows, key), shares)
    return float(low), float(high)
