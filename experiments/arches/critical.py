"""Arches as they lose stability and as they have snapped, beside the exact elastica's."""

from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.run.studies.base import Row
from snapjump.statics.critical import find_snap

from ..compositions import composed
from ..designs import AXES
from . import exact


def critical_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each pair of mismatch and pre-compression: energies in EI/L, depths in L.

    h1: of the lowest point as the arch loses stability; h2: of the snapped arch's middle.
    """
    simulation = composed(inputs["groups"])
    rows = []
    for delta_alpha in inputs["delta_alphas_rad"]:
        for epsilon in inputs["epsilons"]:
            snap = find_snap(simulation.robot, simulation.discretization, epsilon, delta_alpha)
            rows.append(
                {
                    "epsilon": epsilon,
                    "delta_alpha_rad": delta_alpha,
                    "alpha_critical_rad": float(snap.alpha_rad),
                    "energy_before_bar": snap.before.energy,
                    "energy_after_bar": snap.after.energy,
                    "energy_released_bar": snap.before.energy - snap.after.energy,
                    "h1_bar": snap.h1_bar,
                    "h2_bar": snap.h2_bar,
                }
            )
    return rows


def within(rows: Sequence[Row]) -> list[Row]:
    """The rows of the paper's range of epsilon, ends included."""
    low, high = next(axis.range for axis in AXES if axis.column == "epsilon")
    return [row for row in rows if low - 1e-9 <= row["epsilon"] <= high + 1e-9]


def exact_value(epsilon: float, delta_alpha: float, key: str) -> float | None:
    """The exact number beside a row of an arch, by its key; None where there is none: h1 is known
    of clamps that turn alike."""
    if epsilon not in (exact.SYMMETRIC if delta_alpha == 0.0 else exact.COMPARED):
        return None
    if delta_alpha == 0.0:
        entry = exact.symmetric(epsilon)
        released, middle = entry["dE_asym"], -entry["ymid_after_asym"]
        lowest: float | None = -entry["ymin_before_asym"]
    else:
        entry = exact.mismatched(epsilon, delta_alpha, stretches=False)
        released, middle = entry["before_E"] - entry["after_E"], -entry["after_ymid"]
        lowest = None
    return {"energy_released_bar": released, "h1_bar": lowest, "h2_bar": middle}[key]


def exact_points(rows: Sequence[Row], key: str) -> tuple[list[float], list[float]]:
    """Pre-compressions of a curve at which there is an exact number, and these numbers."""
    pairs = [(r["epsilon"], exact_value(r["epsilon"], r["delta_alpha_rad"], key)) for r in rows]
    known = [(epsilon, value) for epsilon, value in pairs if value is not None]
    return [epsilon for epsilon, _ in known], [value for _, value in known]


def largest_difference(rows: Sequence[Row], keys: Sequence[str]) -> float:
    """Of ours from the exact numbers (%), wherever there is one."""
    found = [0.0]
    for row in rows:
        for key in keys:
            value = exact_value(row["epsilon"], row["delta_alpha_rad"], key)
            if value is not None:
                found.append(100.0 * abs(row[key] / value - 1.0))
    return max(found)
