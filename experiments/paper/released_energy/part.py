"""``figure=released_energy``: what a snap releases, and the arch's depths, by pre-compression."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.tiers import TIERS

from ...arches import exact
from ...arches.critical import critical_rows, largest_difference, within
from ...compositions import Groups, changed, composed, groups_at
from ...trends import Line, straight_line
from ..base import Found, Part, Statement, weakest
from ..limits import judged
from ..settings import RANGES
from ..words import Words
from . import figure

Array = NDArray[np.float64]
WORDS = Words(__file__)
LOW, HIGH = RANGE = RANGES["epsilon"]
FINE = tuple(round(0.01 * k, 2) for k in range(1, 31))  # epsilon
COARSE = (*FINE[:6], *FINE[7::2])
OWN = tuple(round(LOW + 0.02 * k, 2) for k in range(11))  # epsilon, on the program's mesh
MISMATCHES_RAD = (0.1, 0.19)
SMALL_RAD = 0.05  # a mismatch that h2 is compared with
OWN_ELEMENTS = int(TIERS["paper"].numbers["discretization.elements"])
STATIC_ELEMENTS = 99  # of the paper's static studies, which have 100 nodes
ENERGY, HEIGHTS = "energy_released_bar", ("h1", "h2")
# Names of cells.
ALIKE, SMALL, REFERENCE = "clamps alike", "small mismatch", "reference"
PAPER, PAPER_SMALL, PAPER_STATIC = "paper", "paper, small mismatch", "paper, 100 nodes"
KINDS = {  # of arches, as in the table of the program's polynomials
    ALIKE: "converged",
    SMALL: f"converged, Δα = {SMALL_RAD:g}",
    PAPER: f"two fixed nodes, {OWN_ELEMENTS} elements (the program's)",
    PAPER_STATIC: f"two fixed nodes, {STATIC_ELEMENTS} elements",
    PAPER_SMALL: f"two fixed nodes, {OWN_ELEMENTS} elements, Δα = {SMALL_RAD:g}",
}


def lagging(delta_alpha: float) -> str:
    """The name of the cell with this mismatch."""
    return f"mismatch {delta_alpha:g}"


def arches(groups: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Inputs of each cell, by its name: the converged arch, the same at reference, and the paper's
    clamps on two meshes."""
    standard, paper = groups_at(groups, "standard"), groups_at(groups, "paper")
    finer = changed(paper, {"discretization": {"elements": STATIC_ELEMENTS}})

    def inputs(made: Groups, epsilons: Sequence[float], *mismatches: float) -> dict[str, Any]:
        return {"kind": "arches", "groups": made, "epsilons": epsilons,
                "delta_alphas_rad": mismatches}  # fmt: skip

    return {
        ALIKE: inputs(standard, FINE, 0.0),
        **{lagging(d): inputs(standard, COARSE, d) for d in MISMATCHES_RAD},
        REFERENCE: inputs(groups_at(groups, "reference"), exact.COMPARED, 0.0, *MISMATCHES_RAD),
        SMALL: inputs(standard, exact.COMPARED, SMALL_RAD),
        PAPER: inputs(paper, OWN, 0.0),
        PAPER_SMALL: inputs(paper, exact.COMPARED, SMALL_RAD),
        PAPER_STATIC: inputs(finer, exact.COMPARED, 0.0),
    }


def energy_line(rows: Sequence[Row]) -> Line:
    """Through the released energy of these rows."""
    return straight_line(column(rows, "epsilon"), column(rows, ENERGY))


def fit_errors(rows: Sequence[Row], name: str) -> Array:
    """The released program's polynomial against a depth of ours, of every row (%)."""
    fit = exact.released_height(name, column(rows, "epsilon"))
    return np.asarray(100.0 * (fit / column(rows, f"{name}_bar") - 1.0))


def left_by_quadratics(rows: Sequence[Row], name: str) -> float:
    """What the best quadratic through a depth of these rows is off by at most (%)."""
    epsilon, depth = column(rows, "epsilon"), column(rows, f"{name}_bar")
    best = np.polyval(np.polyfit(epsilon, depth, 2), epsilon)
    return float(np.max(100.0 * np.abs(best / depth - 1.0)))


def energy_verdict(alike: Sequence[Row]) -> str:
    """Whether the released energy of clamps that turn alike is linear over the paper's range."""
    return judged("released_energy.linear", energy_line(within(alike)).deviation_percent)


def heights_verdict(alike: Sequence[Row], own_mesh: Sequence[Row]) -> str:
    """Whether the polynomials are what the converged arch does; or that on the program's mesh."""
    off = {
        kind: float(np.abs([fit_errors(rows, name) for name in HEIGHTS]).max())
        for kind, rows in (("converged", within(alike)), ("own_mesh", own_mesh))
    }
    return weakest(*(judged(f"released_energy.heights.{k}", one) for k, one in off.items()))


def law(line: Line) -> str:
    """A line in words."""
    sign = "-" if line.intercept < 0.0 else "+"
    return f"{line.slope:.3g} ε {sign} {abs(line.intercept):.2g}"


def linear(alike: Sequence[Row], own_mesh: Sequence[Row], off: Sequence[float]) -> Statement:
    """Lines over the paper's range, over all, and on the paper's mesh; ``off``: of the exact
    elastica, at standard and at reference (%)."""
    slope = exact.shallow()["E_over_eps_released"]
    epsilon, line, whole = column(alike, "epsilon"), energy_line(within(alike)), energy_line(alike)
    more = 100.0 * (column(alike, ENERGY) / (slope * epsilon) - 1.0)
    return WORDS.statement(
        "linear", energy_verdict(alike), line=line, law=law(line), meshed=energy_line(own_mesh),
        least=epsilon[0], range=RANGE, whole=whole, whole_law=law(whole), shallow=slope,
        more=(more[int(np.argmin(np.abs(epsilon - LOW)))], more[-1]), off=off,
    )  # fmt: skip


def polynomials(
    alike: Sequence[Row],
    own_mesh: Sequence[Row],
    fits: Mapping[str, Sequence[Array]],
    off: Sequence[float],
) -> Statement:
    """The program's polynomials; ``fits``: errors of h1 and h2 for the converged arch, on the
    program's mesh, and there with a small mismatch."""
    spans = {
        name: [f"{one.min():+.2g} to {one.max():+.2g}" for one in errors]
        for name, errors in fits.items()
    }
    factor, rows = exact.released_factor(), within(alike)
    gaps = factor * exact.released_height("h1", column(rows, "epsilon")) - column(rows, "h1_bar")
    return WORDS.statement(
        "heights", heights_verdict(alike, own_mesh), factor=factor, gap=gaps.max(),
        left=left_by_quadratics(own_mesh, "h2"), mismatch_rad=SMALL_RAD, off=off, **spans,
    )  # fmt: skip


def told(
    curves: Mapping[float, Sequence[Row]], small: Sequence[Row], unit_mJ: float
) -> dict[str, Any]:
    """Values of the text; ``small``: arches with a small mismatch."""
    alike, far = curves[0.0], max(curves)
    energies = dict(zip(column(alike, "epsilon"), column(alike, ENERGY), strict=True))
    first, last = energies[LOW], energies[HIGH]
    less = [100.0 * (1.0 - curves[lag][-1][ENERGY] / last) for lag in MISMATCHES_RAD]
    deepest = [rows[-1]["h1_bar"] / alike[-1]["h1_bar"] for rows in (small, curves[far])]
    return {
        "range": RANGE,
        "energies": (first, last),
        "energies_mJ": (first * unit_mJ, last * unit_mJ),
        "lags": " and ".join(f"{lag:g}" for lag in MISMATCHES_RAD),
        "shares": " and ".join(f"{share:.2g} %" for share in less),
        "small": small[0]["delta_alpha_rad"],
        "far": far,
        "deeper": [100.0 * (ratio - 1.0) for ratio in deepest],
    }


def line_rows(curves: Mapping[float, Sequence[Row]]) -> list[Row]:
    """Best lines at each mismatch, over the paper's range and over all."""
    table = []
    for delta_alpha, rows in curves.items():
        for chosen in (within(rows), rows):
            line = energy_line(chosen)
            table.append(
                {
                    "Δα (rad)": delta_alpha,
                    "ε from": chosen[0]["epsilon"],
                    "to": chosen[-1]["epsilon"],
                    "slope (EI/L)": line.slope,
                    "intercept (EI/L)": line.intercept,
                    "largest deviation (%)": line.deviation_percent,
                    "at ε": line.worst_place,
                }
            )
    return table


def error_rows(rows: Mapping[str, Sequence[Row]]) -> list[Row]:
    """h1 and h2 of the released program against each kind of arch."""
    table = []
    for cell, kind in KINDS.items():
        chosen = [row for row in rows[cell] if row["epsilon"] in exact.COMPARED]
        errors = {name: fit_errors(chosen, name) for name in HEIGHTS}
        table.append(
            {"arch": kind}
            | {f"{name}, ε = {one['epsilon']:g}": float(errors[name][k])
               for name in HEIGHTS for k, one in enumerate(chosen)}
        )  # fmt: skip
    return table


class ReleasedEnergy(Part):
    """Critical states at many pre-compressions, three mismatches, and the paper's meshes."""

    name = "released_energy"
    title = "The energy that the snap releases, and the depths h1 and h2"
    kinds = {"arches": critical_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """The converged arch; the same at reference; the paper's clamps on two meshes."""
        return [Cell(name, inputs) for name, inputs in arches(groups).items()]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Two statements, from all cells."""
        rows = {name: one.rows for name, one in done.items()}
        alike, own_mesh = rows[ALIKE], rows[PAPER]
        curves = {0.0: alike, **{d: rows[lagging(d)] for d in MISMATCHES_RAD}}
        converged = [row for curve in curves.values() for row in curve]
        # Beside the exact elastica: over the paper's range, everywhere, and at reference.
        energy_off = [largest_difference(one, [ENERGY])
                      for one in (within(converged), converged, rows[REFERENCE])]  # fmt: skip
        depths = [f"{name}_bar" for name in HEIGHTS]
        depths_off = [
            largest_difference(one, depths) for one in (within(converged), rows[REFERENCE])
        ]
        robot = composed(done[ALIKE].cell.inputs["groups"]).robot
        unit_mJ = 1e3 * robot.bending_stiffness_N_m2 / robot.length_m
        line, meshes = energy_line(within(alike)), (within(alike), own_mesh, rows[PAPER_SMALL])
        fits = {name: [fit_errors(one, name) for one in meshes] for name in HEIGHTS}
        figures = {
            "released_energy": partial(figure.draw_energy, curves),
            "released_heights": partial(figure.draw_heights, curves, own_mesh),
        }
        tables = {
            "released_energy_lines": line_rows(curves),
            "released_heights_errors": error_rows(rows),
        }
        section = WORDS.section(
            self.title, figures, tables, off=energy_off, **told(curves, rows[SMALL], unit_mJ)
        )
        energy = linear(alike, own_mesh, energy_off[::2])
        return Found(
            section,
            [energy, polynomials(alike, own_mesh, fits, depths_off)],
            {
                "released_energy_slope_bar": line.slope,
                "released_energy_intercept_bar": line.intercept,
                "released_energy_deviation_percent": line.deviation_percent,
                **{f"{name}_fit_largest_error{kind}_percent": float(np.abs(errors[k]).max())
                   for name, errors in fits.items() for k, kind in enumerate(("", "_own_mesh"))},
            },
        )  # fmt: skip
