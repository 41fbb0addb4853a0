"""The energy that a snap releases, and the depths of the arch, against the pre-compression."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from experiments.compositions import composed
from experiments.paper import exact
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.released_energy.compute import (
    ALIKE,
    MISMATCHES_RAD,
    OWN_ELEMENTS,
    PAPER,
    PAPER_SMALL,
    PAPER_STATIC,
    REFERENCE,
    SMALL,
    SMALL_RAD,
    STATIC_ELEMENTS,
    arches,
    lagging,
    snap_rows,
)
from experiments.paper.released_energy.figure import draw_energy, draw_heights
from experiments.paper.released_energy.judge import (
    HEIGHTS,
    HIGH,
    LOW,
    accuracy_of,
    energy_statement,
    fit_errors,
    heights_statement,
    largest_difference,
    straight_line,
    within,
)
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

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


def deeper(rows: list[Row], alike: list[Row]) -> float:
    """How much deeper the lowest point of the most compressed arch lies than without a mismatch
    (%)."""
    return float(100.0 * (rows[-1]["h1_bar"] / alike[-1]["h1_bar"] - 1.0))


def paragraphs(
    curves: Mapping[float, list[Row]],
    small: list[Row],
    unit_mJ: float,
) -> list[str]:
    """What is shown and what is found."""
    alike = curves[0.0]
    first, last = (within(alike)[k]["energy_released_bar"] for k in (0, -1))
    less = [100.0 * (1.0 - curves[d][-1]["energy_released_bar"] / last) for d in MISMATCHES_RAD]
    shares = " and ".join(f"{share:.2g} %" for share in less)
    names = " and ".join(f"{d:g}" for d in MISMATCHES_RAD)
    everything = [row for curve in curves.values() for row in curve]
    off, off_in_range = (
        largest_difference(rows, ["energy_released_bar"])
        for rows in (everything, within(everything))
    )
    return [
        "The elastic energy at the critical angle less that of the snapped arch at the same "
        f"angle: from {first:.3g} EI/L at ε = {LOW:g} to {last:.3g} EI/L at ε = {HIGH:g}, which "
        f"is {first * unit_mJ:.2g} to {last * unit_mJ:.2g} mJ for the paper's beam. A mismatch of "
        f"{names} rad takes {shares} of it at ε = {HIGH:g}, since the arch snaps earlier. The "
        f"exact elastica, inextensible, has the same energies to {off_in_range:.2g} %, and to "
        f"{off:.2g} % in shallower arches, where the beam's own shortening counts.",
        "In the limit of shallow arches all energies are proportional to ε; the next term, of "
        "order ε², bends the curve upwards. A line with a free intercept takes up most of that "
        "over the paper's range, but it crosses zero before the arch is flat, so that the smaller "
        "ε is, the farther it is off in percent.",
        f"The depth h1 of the critical arch is sensitive to a mismatch, whose first "
        f"{SMALL_RAD:g} rad make it {deeper(small, alike):.2g} % deeper at ε = {HIGH:g}, and "
        f"{MISMATCHES_RAD[1]:g} rad {deeper(curves[MISMATCHES_RAD[1]], alike):.2g} %: close "
        "to a subcritical pitchfork the least disturbance moves the critical state.",
    ]


def line_rows(curves: Mapping[float, list[Row]]) -> list[Row]:
    """Best lines at each mismatch, over the paper's range and over all."""
    table = []
    for delta_alpha, rows in curves.items():
        for chosen in (within(rows), rows):
            line = straight_line(chosen)
            table.append(
                {
                    "Δα (rad)": delta_alpha,
                    "ε from": chosen[0]["epsilon"],
                    "to": chosen[-1]["epsilon"],
                    "slope (EI/L)": line.slope,
                    "intercept (EI/L)": line.intercept,
                    "largest deviation (%)": line.deviation_percent,
                    "at ε": line.worst_epsilon,
                }
            )
    return table


def error_rows(rows: Mapping[str, list[Row]]) -> list[Row]:
    """h1 and h2 of the released program against each kind of arch."""
    kinds = {
        "converged": ALIKE,
        f"converged, Δα = {SMALL_RAD:g}": SMALL,
        f"two fixed nodes, {OWN_ELEMENTS} elements (the program's)": PAPER,
        f"two fixed nodes, {STATIC_ELEMENTS} elements": PAPER_STATIC,
        f"two fixed nodes, {OWN_ELEMENTS} elements, Δα = {SMALL_RAD:g}": PAPER_SMALL,
    }
    table = []
    for kind, cell in kinds.items():
        chosen = [row for row in rows[cell] if row["epsilon"] in exact.COMPARED]
        row: Row = {"arch": kind}
        for name in HEIGHTS:
            for one, error in zip(chosen, fit_errors(chosen, name), strict=True):
                row[f"{name}, ε = {one['epsilon']:g}"] = float(error)
        table.append(row)
    return table
