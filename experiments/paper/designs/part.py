"""``figure=designs``: inverse design of one robot for many targets, and of many robots."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from experiments.inverse_benchmark.methods import LENGTH_MM
from experiments.inverse_benchmark.table import column
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.designs import judge
from experiments.paper.designs.compute import GROUPS, MANY_ROBOTS, MASS_BAR, METHODS, MU, ONE_ROBOT
from experiments.paper.designs.figure import draw_flights, draw_misses
from experiments.paper.learned import shipped_inputs
from experiments.paper.settings import TIERS, groups_at
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

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
                paragraphs(misses),
                {
                    "designs": Figure(CAPTION, partial(draw_flights, shown)),
                    "designs_misses": Figure(MISSES, partial(draw_misses, misses)),
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


CAPTION = (
    "Simulated flights of designs by the forward model (`gauss_newton`), from lift-off to the apex "
    "and on past it (dashed); crosses: targets. Left: one robot; right: eight, of which R4 and R5 "
    "share a target"
)
MISSES = "Misses of all targets at L = 20 mm, judged at three tiers; line: the paper's mean"


def paragraphs(methods: Mapping[str, Sequence[Row]]) -> list[str]:
    """What is shown, what is found, what differs and why."""
    learned = column(methods["gauss_newton"], "miss_standard_mm")
    physics = methods["physics"]
    reachable = sum(bool(row["reachable"]) for row in methods["gauss_newton"])
    own, finer = (column(physics, f"miss_{tier}_mm") for tier in ("standard", "reference"))
    pair = [row for row in methods["gauss_newton"] if row["robot"] in ("R4", "R5")]
    controls = " and ".join(
        f"Δα = {row['delta_alpha_rad']:.3f} rad, ε = {row['epsilon']:.3f} for m̄ = "
        f"{row['mass_bar']:g}, μ = {row['mu']:g}"
        for row in pair
    )
    far = methods["gauss_newton"][int(np.nanargmax(learned))]
    share = np.nanmax(learned) / (LENGTH_MM * far["target_y_bar"])
    return [
        f"{len(ONE_ROBOT)} targets within the region of one robot (m̄ = {MASS_BAR:g}, μ = {MU:g}), "
        f"and {len(MANY_ROBOTS)} robots of different masses on different grounds, each with a "
        f"target within its region; {reachable} of the {len(physics)} are called reachable by the "
        "forward model. Every target is designed for in three ways: `adam`, the paper's "
        "gradient descent on the forward model; `gauss_newton`, which asks the same model; and "
        "`physics`, which corrects by simulations.",
        f"Half of the designs by `gauss_newton` are within {np.nanmedian(learned):.2g} mm of their "
        f"targets. The farthest, {far['robot']} with m̄ = {far['mass_bar']:g}, is "
        f"{np.nanmax(learned):.2g} mm off, {100 * share:.2g} % of its flight's height. Two robots "
        f"reach the same target ({pair[0]['target_x_bar']:g}, {pair[0]['target_y_bar']:g}) L, "
        f"on the same parabola, with {controls}.",
        f"`physics` takes the forward model's error out: {np.nanmean(own):.2g} mm in the mean for "
        f"{np.mean(column(physics, 'simulations')):.2g} simulations a target. Judged at "
        f"`reference` it is {np.nanmean(finer):.2g} mm, the error of the tier that it searched at.",
        "The paper's settings move the apexes themselves, so that designs that are right for "
        f"converged jumps are off by {np.nanmean(column(physics, 'miss_paper_mm')):.2g} mm in the "
        "mean there; and they scatter from one design to the next, which limits what a forward "
        "model can learn from them. The benchmark of inverse design has random targets.",
    ]
