"""Cells of arches under slow loading: the state that loses stability, and the one it snaps to."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import composed
from snapjump.run.studies.base import Row
from snapjump.statics.critical import find_snap


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
