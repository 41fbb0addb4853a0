"""Rows of critical states: energies before and after the snap, and depths."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import Groups, changed, composed
from experiments.paper import exact
from experiments.paper.released_energy.judge import LOW
from experiments.paper.settings import groups_at
from snapjump.run.studies.base import Row
from snapjump.statics.critical import find_snap
from snapjump.tiers import TIERS

FINE = tuple(round(0.01 * k, 2) for k in range(1, 31))  # epsilon
COARSE = (*FINE[:6], *FINE[7::2])
OWN = tuple(round(LOW + 0.02 * k, 2) for k in range(11))  # epsilon, on the program's mesh
MISMATCHES_RAD = (0.1, 0.19)
SMALL_RAD = 0.05  # a mismatch that h2 is compared with
OWN_ELEMENTS = int(TIERS["paper"].numbers["discretization.elements"])
STATIC_ELEMENTS = 99  # of the paper's static studies, which have 100 nodes
# Names of cells.
ALIKE, SMALL, REFERENCE = "clamps alike", "small mismatch", "reference"
PAPER, PAPER_SMALL, PAPER_STATIC = "paper", "paper, small mismatch", "paper, 100 nodes"

Arches = tuple[Groups, tuple[float, ...], tuple[float, ...]]


def lagging(delta_alpha: float) -> str:
    """The name of the cell with this mismatch."""
    return f"mismatch {delta_alpha:g}"


def arches(groups: Mapping[str, Any]) -> dict[str, Arches]:
    """Composition, pre-compressions and mismatches of each cell, by its name: the converged arch,
    the same at reference, and the paper's clamps on two meshes."""
    standard, paper = groups_at(groups, "standard"), groups_at(groups, "paper")
    finer = changed(paper, {"discretization": {"elements": STATIC_ELEMENTS}})
    compared = exact.COMPARED
    return {
        ALIKE: (standard, FINE, (0.0,)),
        **{lagging(d): (standard, COARSE, (d,)) for d in MISMATCHES_RAD},
        REFERENCE: (groups_at(groups, "reference"), compared, (0.0, *MISMATCHES_RAD)),
        SMALL: (standard, compared, (SMALL_RAD,)),
        PAPER: (paper, OWN, (0.0,)),
        PAPER_SMALL: (paper, compared, (SMALL_RAD,)),
        PAPER_STATIC: (finer, compared, (0.0,)),
    }


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
