"""Points of the snap surface: our critical angles beside the elastica's by collocation."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column

from ...arches import exact
from ...arches.critical import critical_rows
from ...compositions import changed, composed, groups_at
from ...order import richardson
from ...paper.words import Words
from ..arches import static_groups
from ..base import Compared, Source, percent_off
from .collocation import Clamps, fold
from .figure import draw_surface

EPSILONS = (0.05, 0.1, 0.2, 0.3)
MISMATCHES_RAD = (0.05, 0.1, 0.2, 0.4)
ELEMENTS = (56, 80, 112, 160, 224)
# A mismatch of which there are folds of another make, and EI/(EA L^2) of their beams: the paper's.
KNOWN_RAD, KNOWN_STRETCHES = 0.1, (0.0, (0.05 / 20.0) ** 2 / 12.0)
COLLOCATION = "collocation"


def mesh_name(elements: int) -> str:
    """The cell of a mesh."""
    return f"{elements} elements"


def collocation_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Folds by collocation: a row for each point, and for each that was known."""
    stretch = 1.0 / composed(inputs["groups"]).robot.stretching_stiffness_bar
    points = [(d, e, stretch) for d in inputs["delta_alphas_rad"] for e in inputs["epsilons"]]
    known = [(KNOWN_RAD, e, lam) for e in exact.COMPARED for lam in KNOWN_STRETCHES]
    rows = []
    for delta, epsilon, lam in [*points, *known]:
        found = fold(Clamps(epsilon, delta, lam))
        rows.append(
            {
                "epsilon": epsilon,
                "delta_alpha_rad": delta,
                "stretch": lam,
                "alpha_critical_rad": found.left,
                "residual": found.residual,
            }
        )
    return rows


class Surface(Source):
    """Points over pre-compression and mismatch, on several meshes."""

    name = "surface"
    words = Words(__file__)
    kinds = {"collocation": collocation_rows, "meshes": critical_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """The collocation, and a cell for each mesh."""
        static = static_groups(groups_at(groups, "standard"))
        where = {"epsilons": EPSILONS, "delta_alphas_rad": MISMATCHES_RAD}

        def cell(name: str, kind: str, made: Any) -> Cell:
            return Cell(name, {"kind": kind, "groups": made, **where})

        return [
            cell(COLLOCATION, "collocation", static),
            *(
                cell(mesh_name(n), "meshes", changed(static, {"discretization": {"elements": n}}))
                for n in ELEMENTS
            ),
        ]

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """All points, by the worst of them."""
        solved = done[COLLOCATION].rows
        count = len(EPSILONS) * len(MISMATCHES_RAD)
        rows = points(solved[:count], {n: done[mesh_name(n)].rows for n in ELEMENTS})
        known, off = known_percent(solved[count:]), column(rows, "difference_percent")
        worst, orders = rows[int(np.argmax(off))], column(rows, "order")
        order = float(np.abs(orders - 2.0).max())
        finest = [percent_off(row[str(ELEMENTS[-1])], row["collocation_rad"]) for row in rows]
        comparisons = [
            self.compared(
                "surface", f"{worst['extrapolated_rad']:.7f} rad",
                f"{off.max():.2g} % from {worst['collocation_rad']:.7f} rad",
                self.weakest_of(("limit", float(off.max())), ("known", known), ("order", order)),
                count=count, epsilon=worst["epsilon"], delta=worst["delta_alpha_rad"],
                elements=ELEMENTS[-1], finest=max(finest), known=known,
                agrees=self.by_limit("known", known),
                least=orders.min(), most=orders.max(), second=self.by_limit("order", order),
            ),
        ]  # fmt: skip
        section = self.section(
            comparisons, {"surface": partial(draw_surface, rows, ELEMENTS)},
            {"surface_points": rows},
            {"surface_points": dict.fromkeys([*map(str, ELEMENTS), "collocation_rad",
                                              "extrapolated_rad", "sum_rad"], 7)},
            stretch=solved[0]["stretch"], residual=float(column(solved, "residual").max()),
        )  # fmt: skip
        summary = {"surface_difference_percent": float(off.max()), "surface_known_percent": known}
        return Compared(section, [], summary, comparisons)


def points(solved: Sequence[Row], meshes: Mapping[int, Sequence[Row]]) -> list[Row]:
    """Each point with the angles of all meshes, and what they tend to."""
    rows = []
    for k, one in enumerate(solved):
        angles = {n: float(own[k]["alpha_critical_rad"]) for n, own in meshes.items()}
        limit = richardson([1.0 / n for n in angles], [*angles.values()])
        rows.append(
            {
                "epsilon": one["epsilon"],
                "delta_alpha_rad": one["delta_alpha_rad"],
                **{str(n): angle for n, angle in angles.items()},
                "extrapolated_rad": limit.value,
                "collocation_rad": one["alpha_critical_rad"],
                "sum_rad": 2.0 * one["alpha_critical_rad"] - one["delta_alpha_rad"],
                "difference_percent": percent_off(limit.value, one["alpha_critical_rad"]),
                "order": limit.order,
            }
        )
    return rows


def known_percent(solved: Sequence[Row]) -> float:
    """The largest difference of folds from those that were known (%)."""
    return max(
        percent_off(
            row["alpha_critical_rad"],
            exact.mismatched(row["epsilon"], KNOWN_RAD, row["stretch"] > 0.0)["aL"],
        )
        for row in solved
    )
