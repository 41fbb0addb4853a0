"""The energy that a snap releases, and the depths of the arch, against the pre-compression."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from experiments.compositions import composed
from experiments.paper.base import Found, Part
from experiments.paper.released_energy.arches import (
    ALIKE,
    MISMATCHES_RAD,
    PAPER,
    PAPER_SMALL,
    REFERENCE,
    SMALL,
    arches,
    lagging,
)
from experiments.paper.released_energy.compute import snap_rows
from experiments.paper.released_energy.figure import draw_energy
from experiments.paper.released_energy.fits import HEIGHTS, fit_errors, straight_line, within
from experiments.paper.released_energy.heights_figure import draw_heights
from experiments.paper.released_energy.judge import (
    accuracy_of,
    energy_statement,
    heights_statement,
)
from experiments.paper.released_energy.report import error_rows, line_rows, paragraphs
from experiments.paper.unfinished import unfinished
from snapjump.studies.base import Cell, Done, Figure, Row, Section, Table

TITLE = "The energy that the snap releases, and the depths h1 and h2"


class ReleasedEnergy(Part):
    """Critical states at many pre-compressions, three mismatches, and the paper's meshes."""

    name = "released_energy"
    sources = ("experiments.paper.released_energy.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """The converged arch; the same at reference; the paper's clamps on two meshes."""
        return [
            Cell(name, {"groups": made, "epsilons": epsilons, "delta_alphas_rad": mismatches})
            for name, (made, epsilons, mismatches) in arches(groups).items()
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """A row for each critical state."""
        return snap_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Two statements, from all cells."""
        missing = unfinished(TITLE, done)
        if missing is not None:
            return missing
        rows = {name: one.rows for name, one in done.items()}
        alike = rows[ALIKE]
        curves = {0.0: alike, **{d: rows[lagging(d)] for d in MISMATCHES_RAD}}
        converged = [row for curve in curves.values() for row in curve]
        heights = [f"{name}_bar" for name in HEIGHTS]
        robot = composed(done[ALIKE].cell.inputs["groups"]).robot
        unit_mJ = 1e3 * robot.bending_stiffness_N_m2 / robot.length_m
        figures = {
            "released_energy": Figure(
                "Energy released by the snap; how far it is from a straight line; and over ε, "
                "where an exact proportion would be level. Circles: exact",
                partial(draw_energy, curves),
            ),
            "released_heights": Figure(
                "Depth h1 of the lowest point of the critical arch and depth h2 of the snapped "
                "arch's middle, with the released program's polynomials; and how far these are off",
                partial(draw_heights, curves, rows[PAPER]),
            ),
        }
        return Found(
            Section(
                TITLE,
                paragraphs(curves, rows[SMALL], unit_mJ),
                figures,
                {
                    "released_energy_lines": Table("Straight lines", line_rows(curves)),
                    "released_heights_errors": Table(
                        "The released program's polynomials against arches (%)",
                        error_rows(rows),
                    ),
                },
            ),
            [
                energy_statement(
                    alike,
                    rows[PAPER],
                    accuracy_of(converged, rows[REFERENCE], ["energy_released_bar"]),
                ),
                heights_statement(
                    alike,
                    rows[PAPER],
                    rows[PAPER_SMALL],
                    accuracy_of(converged, rows[REFERENCE], heights),
                ),
            ],
            summary(alike, rows[PAPER]),
        )


def summary(alike: list[Row], own: list[Row]) -> dict[str, float]:
    """Flat numbers."""
    line = straight_line(within(alike))
    numbers = {
        "released_energy_slope_bar": line.slope,
        "released_energy_intercept_bar": line.intercept,
        "released_energy_deviation_percent": line.deviation_percent,
    }
    for name in HEIGHTS:
        converged, meshed = fit_errors(within(alike), name), fit_errors(own, name)
        numbers[f"{name}_fit_largest_error_percent"] = float(abs(converged).max())
        numbers[f"{name}_fit_largest_error_own_mesh_percent"] = float(abs(meshed).max())
    return numbers
