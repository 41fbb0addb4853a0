"""Trajectories of jumps, and what the mismatch does to them."""

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from experiments.designs import spread_designs
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.jumps import numbers
from experiments.paper.settings import BASELINE, TIERS, groups_at
from experiments.paper.trajectories.compute import (
    DESIGNS,
    FAMILIES,
    FOLLOWED,
    STRIDE,
    mismatches,
    rows_of,
    varied,
)
from experiments.paper.trajectories.figure import draw_angles, draw_flights
from experiments.paper.trajectories.judge import trajectory_statement
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

TITLE = "Trajectories"
FLIGHTS, MISMATCHES, SPREAD, PATH = "flights", "mismatches", "ranges", "path to lift-off"
DRAWN = ("standard", "paper")
RISES = 0.01, 0.03  # L, of the centre of mass: between them the beam slides in every flight


class Trajectories(Part):
    """Families of jumps, a sweep of the mismatch, and designs of all the ranges."""

    name = "trajectories"
    sources = ("experiments.paper.trajectories.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Families and sweeps by tier, then the ranges and the paths at standard."""
        at = {tier: groups_at(groups, tier) for tier in TIERS}
        standard = at["standard"]
        families = [d for name, values in FAMILIES.items() for d in varied(name, values)]
        cells = [
            Cell(f"{FLIGHTS}, {tier}", {"groups": at[tier], "designs": families}) for tier in DRAWN
        ]
        cells += [
            Cell(
                f"{MISMATCHES}, {tier}",
                {"groups": at[tier], "designs": mismatches(1 if tier in DRAWN else STRIDE)},
            )
            for tier in TIERS
        ]
        spread = spread_designs(DESIGNS, seed)
        cells.append(Cell(SPREAD, {"groups": standard, "designs": spread}))
        return cells + [
            Cell(f"{PATH}, {design[0]:g}", {"groups": standard, "followed": design})
            for design in varied("delta_alpha_rad", FOLLOWED)
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """Jumps, or a path."""
        return rows_of(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """One statement; the families, the angles, and the paths to lift-off."""
        # Failures among the many designs are told, and left out.
        needed = {name: one for name, one in done.items() if name != SPREAD}
        missing = unfinished(TITLE, needed, jumps=True) or unfinished(TITLE, done)
        if missing is not None:
            return missing
        rows = {name: one.rows for name, one in done.items()}
        flights = {tier: rows[f"{FLIGHTS}, {tier}"] for tier in DRAWN}
        sweeps = {tier: rows[f"{MISMATCHES}, {tier}"] for tier in TIERS}
        paths = {lag: rows[f"{PATH}, {lag:g}"] for lag in FOLLOWED}
        statement, summary = trajectory_statement(sweeps, rows[SPREAD])
        figures = {
            "trajectories": Figure(
                "Flights of the centre of mass, to scale: lines at standard, dashed with the "
                "paper's settings, dots at the apexes. One number of the baseline varies in each",
                partial(draw_flights, flights),
            ),
            "trajectories_angles": Figure(
                "x_c/y_c against the mismatch, and the path of the centre of mass until the robot "
                "has left the ground",
                partial(draw_angles, sweeps, paths),
            ),
        }
        table = Table("The flights of the figure", table_rows(flights))
        return Found(
            Section(TITLE, paragraphs(sweeps, paths), figures, {"trajectories": table}),
            [statement],
            summary,
        )


def first_slope(rows: list[Row]) -> float:
    """dx/dy of a path while the centre of mass rises through the first of its way."""
    x, y = numbers(rows, "x_bar"), numbers(rows, "y_bar")
    low, high = (int(np.flatnonzero(y > y[0] + rise)[0]) for rise in RISES)
    return float((x[high] - x[low]) / (y[high] - y[low]))


def paragraphs(sweeps: Mapping[str, list[Row]], paths: Mapping[float, list[Row]]) -> list[str]:
    """What is shown, and how the two settings differ."""
    begun = [first_slope(rows) for lag, rows in paths.items() if lag > 0.0]
    own, papers = numbers(sweeps["standard"], "y_bar"), numbers(sweeps["paper"], "y_bar")
    higher = 100.0 * (papers / own - 1.0)
    aside = numbers(sweeps["paper"], "x_bar") - numbers(sweeps["standard"], "x_bar")
    farther = max(-2.0 * aside.min(), 0.0), max(2.0 * aside.max(), 0.0)
    return [
        "Only the mismatch turns the flight aside: a symmetric snap strikes the ground under the "
        "centre of mass and throws the robot straight up. More pre-compression stretches the "
        "flight in both directions, more mass shrinks it. Friction is all that drives the robot "
        "sideways: while the beam slides on the ground, the path of the centre of mass leans by "
        f"the friction coefficient whatever the mismatch (dx/dy = {min(begun):.2f} to "
        f"{max(begun):.2f} where μ = {BASELINE[3]:g}; the weight takes a little of the lift). The "
        "smaller the mismatch, the sooner the "
        "sliding turns back, and the path turns up.",
        f"With the paper's settings the same designs jump {min(higher):.1f} to {max(higher):.1f} % "
        "higher, because no material damping takes part of the energy (see *What causes the "
        f"difference*), and come down up to {farther[0]:.1f} L nearer or {farther[1]:.1f} L "
        "farther.",
    ]


def table_rows(flights: Mapping[str, list[Row]]) -> list[Row]:
    """The families' apexes at both tiers."""
    kept = ("x_bar", "y_bar", "liftoff_vx_m_s", "liftoff_vy_m_s")
    return [
        {
            **{key: own[key] for key in ("delta_alpha_rad", "epsilon", "mass_bar")},
            **{key: own[key] for key in kept},
            **{f"paper_{key}": papers[key] for key in kept},
        }
        for own, papers in zip(flights["standard"], flights["paper"], strict=True)
    ]
