"""The arch whose clamps turn alike: branches of equilibria, the snap, and the way back."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.scenes.swing import follow, outcome

from ...arches import exact
from ...arches.branches import branch_rows, shape_rows
from ...arches.landmarks import (
    LADDER,
    MISMATCH_RAD,
    NAMES,
    RIGID,
    STRETCHES,
    all_rows,
    comparison,
    landmark_rows,
    orders,
    overall,
)
from ...arches.landmarks import largest_difference as off
from ...arches.swings import PAPER_ELEMENTS, snap_groups, snap_of
from ...compositions import changed, composed, groups_at
from ..base import Found, Part, Statement, listed, span, weakest
from ..limits import LIMITS, judged
from ..words import Words
from .figure import draw_angles, draw_branches, draw_loop

WORDS = Words(__file__)
SHOWN = 0.2  # epsilon of the shapes, the paper's baseline
GRID = (0.01, *(round(0.02 * k, 2) for k in range(1, 16)))  # epsilon
TIERS = (*LADDER, "paper")
NODES = f"paper, {PAPER_ELEMENTS + 1} nodes"  # of the paper's study of the snap
STEPS_S = (1e-3, 1e-5)  # the paper's of that study, and that of its jumps


def angle_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """The landmarks at each pre-compression."""
    return landmark_rows(composed(inputs["groups"]), inputs["epsilons"])


def compared_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """The same with all that there are exact numbers for."""
    return all_rows(composed(inputs["groups"]), inputs["epsilons"])


def step_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """The snap of mismatched clamps at the paper's settings, with each step."""
    groups = inputs["groups"]
    stepped = {s: changed(groups, {"stepping": {"step_s": s}}) for s in inputs["steps_s"]}
    return [
        {"step_s": s, **outcome(follow(snap_of(one, inputs["epsilon"], MISMATCH_RAD)))}
        for s, one in stepped.items()
    ]


class Bifurcation(Part):
    """Branches at three pre-compressions; critical angles; all beside the exact elastica."""

    name = "bifurcation"
    title = "The critical angle, and the loop"
    kinds = {
        "branches": branch_rows,
        "shapes": shape_rows,
        "angles": angle_rows,
        "compared": compared_rows,
        "steps": step_rows,
    }

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Branches and shapes at `standard`; landmarks at each tier's mesh, and the paper's."""
        standard, nodes = groups_at(groups, "standard"), snap_groups(groups, "paper")
        at = {tier: groups_at(groups, tier) for tier in TIERS} | {NODES: nodes}

        def cell(name: str, kind: str, made: Any = standard, **values: Any) -> Cell:
            return Cell(name, {"kind": kind, "groups": made, **values})

        return [
            *(cell(f"branches {e:g}", "branches", epsilon=e) for e in exact.COMPARED),
            cell("shapes", "shapes", epsilon=SHOWN),
            cell("angles", "angles", epsilons=GRID),
            *(cell(name, "compared", made, epsilons=exact.COMPARED) for name, made in at.items()),
            cell("steps", "steps", nodes, epsilon=exact.COMPARED[0], steps_s=STEPS_S),
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Four statements."""
        rows = {name: one.rows for name, one in done.items()}
        tiers = {tier: rows[tier] for tier in TIERS}
        marks, angles = rows["standard"], rows["angles"]
        branches = {e: rows[f"branches {e:g}"] for e in exact.COMPARED}
        shown = next(row for row in marks if row["epsilon"] == SHOWN)
        errors = [(t, own[0]["elements"], overall(own, STRETCHES)[0]) for t, own in tiers.items()]
        angle = partial(draw_angles, angles, [gap_percent(r) for r in angles], errors[:-1])
        figures = {
            "bifurcation_loop": partial(draw_loop, rows["shapes"], branches[SHOWN], shown),
            "bifurcation": partial(draw_branches, branches, marks),
            "bifurcation_angles": partial(angle, errors[-1]),
        }
        rigid, order = exactness(tiers, RIGID), span(orders(tiers))
        values = {**exactness(tiers), "rigid": rigid, "order": order, "shown": SHOWN}
        compared = comparison({**tiers, NODES: rows[NODES]})
        return Found(
            WORDS.section(self.title, figures, {"bifurcation_exact": compared}, **values),
            [
                snap_statement(tiers),
                growth_statement(angles, tiers),
                fold_statement(angles, tiers),
                nodes_statement(rows[NODES], rows["steps"]),
            ],
            summary(tiers),
        )


def exactness(tiers: Mapping[str, Sequence[Row]], beam: str = STRETCHES) -> dict[str, Any]:
    """The largest difference (%) from an exact beam by tier, and what it is of."""
    return {tier: overall(rows, beam) for tier, rows in tiers.items()}


def snaps(row: Row) -> bool:
    """Whether the arch gets to a stable state of less energy on the other side, and stays there
    when its clamps turn back to where it snapped."""
    least = LIMITS["bifurcation.snap.loop"].confirmed / 100.0
    return bool(
        row["midpoint_after_bar"] < 0.0 < row["midpoint_before_bar"]
        and row["negative_pivots_after"] == 0
        and row["energy_after_bar"] < row["energy_before_bar"]
        and loop_width(row) > least * row["alpha_critical_rad"]
    )


def loop_width(row: Row) -> float:
    """Between the snaps there and back (rad)."""
    return float(row["alpha_critical_rad"] - row["alpha_back_rad"])


def gap_percent(row: Row) -> float:
    """How much later the fold comes than the first instability (% of the angle)."""
    return float(100.0 * (row["alpha_fold_rad"] / row["alpha_critical_rad"] - 1.0))


def snap_statement(tiers: Mapping[str, Sequence[Row]]) -> Statement:
    """Instability at a critical angle, the snap to the other side, and the hysteresis."""
    rows = tiers["standard"]
    errors = {tier: off(found, "alpha_critical_rad") for tier, found in tiers.items()}
    held = sum(snaps(row) for row in rows)
    came = weakest(
        judged("bifurcation.snap.arches", held / len(rows)),
        judged("bifurcation.snap.angle", errors["standard"]),
    )
    return WORDS.statement(
        "snap",
        came,
        **exactness(tiers),
        angles=listed(column(rows, "alpha_critical_rad"), ".4f"),
        epsilons=listed(row["epsilon"] for row in rows),
        held=held,
        count=len(rows),
        mirrored=max(abs(row["alpha_critical_rad"] + row["alpha_back_rad"]) for row in rows),
        widths=listed([loop_width(row) for row in rows], ".3f"),
        errors=errors,
    )


def growth_statement(angles: Sequence[Row], tiers: Mapping[str, Sequence[Row]]) -> Statement:
    """The critical angle against the pre-compression."""
    epsilon, alpha = column(angles, "epsilon"), column(angles, "alpha_critical_rad")
    falls = np.diff(alpha) <= 0.0
    inside = epsilon[1:] >= min(row["epsilon"] for row in tiers["standard"])
    came = weakest(
        judged("bifurcation.growth", falls.sum()),
        judged("bifurcation.growth.range", falls[inside].sum()),
    )
    return WORDS.statement(
        "growth",
        came,
        **exactness(tiers),
        first=angles[0],
        last=angles[-1],
        rises=(~falls).sum(),
        steps=len(falls),
        ratio=span(alpha / np.sqrt(epsilon)),
    )


def fold_statement(angles: Sequence[Row], tiers: Mapping[str, Sequence[Row]]) -> Statement:
    """Whether the symmetric fold is the first instability."""
    rows = tiers["standard"]
    times = LIMITS["bifurcation.fold.error"].confirmed
    gaps, on_paper = ([gap_percent(row) for row in one] for one in (angles, tiers["paper"]))
    beyond = sum(gap >= times * off(rows, "alpha_critical_rad") for gap in gaps)
    came = judged("bifurcation.fold", 1.0 - beyond / len(gaps))
    higher = [100.0 * (r["midpoint_before_bar"] / r["midpoint_fold_bar"] - 1.0) for r in rows]
    return WORDS.statement(
        "fold",
        came,
        **exactness(tiers),
        beyond=beyond,
        count=len(gaps),
        leaning=100.0 * min(row["leaning"] for row in angles),
        gaps=span(gaps),
        first=angles[0],
        last=angles[-1],
        on_paper=span(on_paper),
        compared=span(row["epsilon"] for row in rows),
        energy=max(100.0 * (r["energy_fold_bar"] / r["energy_before_bar"] - 1.0) for r in rows),
        higher=span(higher),
    )


def nodes_statement(rows: Sequence[Row], steps: Sequence[Row]) -> Statement:
    """Whether the static study has converged; ``rows``: landmarks on the paper's mesh for it, of
    which the fold is not stable and not seen there; ``steps``: snaps with its step, and with a
    hundredth of that."""
    static = [(off(rows, key), NAMES[key][0]) for key in NAMES if "fold" not in key]
    late, tilted = (
        100.0 * (coarse / fine - 1.0)
        for coarse, fine in (column(steps, key) for key in ("alpha_snap_rad", "theta_max_rad"))
    )
    came = weakest(
        judged("bifurcation.nodes", *(error for error, _ in static)),
        judged("bifurcation.nodes.step", abs(late)),
    )
    return WORDS.statement(
        "nodes",
        came,
        worst=max(static),
        angle=off(rows, "alpha_critical_rad"),
        off=(late, tilted),
        steps_ms=[1e3 * row["step_s"] for row in steps],
        fine=steps[1],
    )


def summary(tiers: Mapping[str, Sequence[Row]]) -> dict[str, float]:
    """Flat numbers: angles and loops at standard, and the differences from the exact ones."""
    found = {}
    for row in tiers["standard"]:
        place = f"eps_{row['epsilon']:g}".replace(".", "_")
        found[f"alpha_critical_{place}_rad"] = row["alpha_critical_rad"]
        found[f"alpha_fold_{place}_rad"] = row["alpha_fold_rad"]
        found[f"loop_width_{place}_rad"] = loop_width(row)
    for tier, rows in tiers.items():
        found[f"statics_{tier}_largest_difference_percent"] = overall(rows, STRETCHES)[0]
    return found
