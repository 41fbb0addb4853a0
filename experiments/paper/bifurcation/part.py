"""The arch whose clamps turn alike: branches of equilibria, the snap, and the way back."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from experiments.paper import exact
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.bifurcation.compute import (
    angle_rows,
    branch_rows,
    compared_rows,
    shape_rows,
)
from experiments.paper.bifurcation.figure import draw_angles, draw_branches, draw_loop
from experiments.paper.bifurcation.judge import (
    LADDER,
    RIGID,
    STRETCHES,
    comparison,
    fold_statement,
    growth_statement,
    loop_width,
    orders,
    overall,
    snap_statement,
)
from experiments.paper.settings import groups_at
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

TITLE = "The critical angle, and the loop"
SHOWN = 0.2  # epsilon of the shapes, the paper's baseline
GRID = (0.01, *(round(0.02 * k, 2) for k in range(1, 16)))  # epsilon
TIERS = (*LADDER, "paper")
KINDS = {
    "branches": branch_rows,
    "shapes": shape_rows,
    "angles": angle_rows,
    "compared": compared_rows,
}


class Bifurcation(Part):
    """Branches at three pre-compressions; critical angles; all beside the exact elastica."""

    name = "bifurcation"
    sources = ("experiments.paper.bifurcation.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Branches and shapes at `standard`; landmarks at each tier's mesh."""
        groups = groups_at(groups, "standard")
        cells = [
            Cell(f"branches {e:g}", {"kind": "branches", "groups": groups, "epsilon": e})
            for e in exact.COMPARED
        ]
        cells.append(Cell("shapes", {"kind": "shapes", "groups": groups, "epsilon": SHOWN}))
        cells.append(Cell("angles", {"kind": "angles", "groups": groups, "epsilons": GRID}))
        return cells + [
            Cell(
                tier,
                {"kind": "compared", "groups": groups_at(groups, tier), "epsilons": exact.COMPARED},
            )
            for tier in TIERS
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The rows of one of the four kinds of cells."""
        return KINDS[inputs["kind"]](inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Three statements, from all cells."""
        missing = unfinished(TITLE, done)
        if missing is not None:
            return missing
        rows = {name: one.rows for name, one in done.items()}
        tiers = {tier: rows[tier] for tier in TIERS}
        marks, angles = rows["standard"], rows["angles"]
        branches = {e: rows[f"branches {e:g}"] for e in exact.COMPARED}
        shown = next(row for row in marks if row["epsilon"] == SHOWN)
        figures = {
            "bifurcation_loop": Figure(
                f"Shapes before, at and after the snap (ε = {SHOWN:g}); height of the middle "
                "against the clamp angle, forwards and back; and close by the first instability. "
                "Solid: stable; dashed: symmetric and unstable; dotted: leaning and unstable; "
                "circles: exact",
                partial(draw_loop, rows["shapes"], branches[SHOWN], shown),
            ),
            "bifurcation": Figure(
                "Height of the middle and elastic energy of all equilibria on these branches, "
                "and exact ones",
                partial(draw_branches, branches, marks),
            ),
            "bifurcation_angles": Figure(
                "Critical angle against pre-compression; how much later the symmetric fold comes; "
                "the largest difference from the exact elastica, of angles, energies and heights, "
                "against the mesh",
                partial(draw_angles, angles, tiers),
            ),
        }
        table = Table(
            "Largest differences from the exact elastica at ε = 0.1, 0.2 and 0.3", comparison(tiers)
        )
        return Found(
            Section(TITLE, paragraphs(tiers), figures, {"bifurcation_exact": table}),
            [
                snap_statement(tiers),
                growth_statement(angles, tiers),
                fold_statement(angles, tiers),
            ],
            summary(tiers),
        )


def paragraphs(tiers: Mapping[str, list[Row]]) -> list[str]:
    """What is shown, what is found, and how exact it is."""
    observed = orders(tiers)
    told = {
        tier: (overall(tiers[tier], STRETCHES), overall(tiers[tier], RIGID))
        for tier in ("standard", "reference", "paper")
    }
    return [
        "Both clamps turn alike and slowly. The arch that is buckled up follows its branch until "
        "this loses its stability, snaps to the branch that is buckled down, and stays there when "
        "the clamps turn back, beyond the flat ones, until that branch loses its stability at the "
        "mirrored angle: a loop. Each branch is walked by continuation, also where it is unstable, "
        "and a point is called stable if its tangent stiffness has no negative eigenvalue.",
        "The symmetric branch does not end in its fold: shortly before, at a subcritical "
        "pitchfork, a branch of leaning shapes leaves it, which is unstable all the way to the "
        "mirrored pitchfork of the other side. A symmetric arch beyond the pitchfork tips over "
        "at the least disturbance.",
        f"Beside the exact elastica of a beam that stretches as the paper's does, `standard` is "
        f"off by at most {told['standard'][0][0]:.2g} % ({told['standard'][0][1]}) and "
        f"`reference` by {told['reference'][0][0]:.2g} %, converging with order "
        f"{observed.min():.2f} to {observed.max():.2f}. Beside an inextensible beam, whose "
        f"heights and energies are known at more points, it is {told['standard'][1][0]:.2g} % and "
        f"{told['reference'][1][0]:.2g} %, the beam's own stretching included. The paper's clamps "
        f"of two fixed nodes are off by up to {told['paper'][0][0]:.2g} % "
        f"({told['paper'][0][1]}) and {told['paper'][1][0]:.2g} % ({told['paper'][1][1]}): each "
        "holds a whole element straight, an error of first order in the mesh.",
    ]


def summary(tiers: Mapping[str, list[Row]]) -> dict[str, float]:
    """Flat numbers: angles and loops at standard, and the differences from the exact ones."""
    numbers = {}
    for row in tiers["standard"]:
        place = f"eps_{row['epsilon']:g}".replace(".", "_")
        numbers[f"alpha_critical_{place}_rad"] = row["alpha_critical_rad"]
        numbers[f"alpha_fold_{place}_rad"] = row["alpha_fold_rad"]
        numbers[f"loop_width_{place}_rad"] = loop_width(row)
    for tier, rows in tiers.items():
        numbers[f"statics_{tier}_largest_difference_percent"] = overall(rows, STRETCHES)[0]
    return numbers
