"""Rows of critical states: energies before and after the snap, and depths."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import composed
from snapjump.statics.critical import find_snap
from snapjump.studies.base import Row


def snap_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each pair of pre-compression and mismatch: energies in EI/L, depths in L."""
    simulation = composed(inputs["groups"])
    robot, mesh = simulation.robot, simulation.discretization
    rows = []
    for delta_alpha in inputs["delta_alphas_rad"]:
        for epsilon in inputs["epsilons"]:
            snap = find_snap(robot, mesh, epsilon, delta_alpha)
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
