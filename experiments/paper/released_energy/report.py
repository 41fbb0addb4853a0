"""Paragraphs and tables on the released energy and the depths."""

from collections.abc import Mapping

from experiments.paper import exact
from experiments.paper.released_energy.arches import (
    ALIKE,
    MISMATCHES_RAD,
    OWN_ELEMENTS,
    PAPER,
    PAPER_SMALL,
    PAPER_STATIC,
    SMALL,
    SMALL_RAD,
    STATIC_ELEMENTS,
)
from experiments.paper.released_energy.fits import (
    HEIGHTS,
    HIGH,
    LOW,
    fit_errors,
    largest_difference,
    straight_line,
    within,
)
from snapjump.studies.base import Row


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
