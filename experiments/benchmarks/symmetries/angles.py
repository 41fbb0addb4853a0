"""Critical angles of shallow arches, of slender beams on several meshes, and what they tend to."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.optimize import brentq

from snapjump.composition import Simulation
from snapjump.run.studies.base import Row
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch
from snapjump.statics.critical import find_snap
from snapjump.statics.landmarks import symmetric_fold

from ...compositions import changed, composed

ONE_END, ALIKE, FOLD = "one end", "alike", "fold"
# Over sqrt(epsilon): shallow arches snap between these when one clamp turns, and the other is flat.
BETWEEN = (1.5, 2.0)
TOLERANCE_RAD = 1e-10


def one_end(simulation: Simulation, epsilon: float) -> float:
    """The left clamp's critical angle (rad) with a flat right one: where the mismatch is as large
    as the angle."""

    def right(mismatch: float) -> float:
        snap = find_snap(simulation.robot, simulation.discretization, epsilon, mismatch)
        return snap.alpha_rad - mismatch

    low, high = (share * np.sqrt(epsilon) for share in BETWEEN)
    return float(brentq(right, low, high, xtol=TOLERANCE_RAD))


def angles(simulation: Simulation, epsilon: float) -> dict[str, float]:
    """The three angles (rad) of an arch: of the fold with one clamp turned, and of the first
    instability and the fold with both turned alike."""
    robot, mesh = simulation.robot, simulation.discretization
    branch = Branch(StaticArch(robot, mesh, epsilon), 0.0)
    return {
        ONE_END: one_end(simulation, epsilon),
        ALIKE: find_snap(robot, mesh, epsilon, 0.0).alpha_rad,
        FOLD: symmetric_fold(branch).left,
    }


def angle_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each pre-compression: angles over its square root."""
    groups = changed(
        inputs["groups"],
        {
            "robot": {"thickness_m": inputs["thickness_m"]},
            "discretization": {"elements": inputs["elements"]},
        },
    )
    simulation = composed(groups)
    return [
        {
            "epsilon": epsilon,
            "stretch": 1.0 / simulation.robot.stretching_stiffness_bar,
            **{name: a / np.sqrt(epsilon) for name, a in angles(simulation, epsilon).items()},
        }
        for epsilon in inputs["epsilons"]
    ]


def at_zero(places: Sequence[float], values: Sequence[float]) -> float:
    """The value at zero of the polynomial through all points."""
    total = 0.0
    for j, value in enumerate(values):
        others = [x for k, x in enumerate(places) if k != j]
        total += value * float(np.prod([x / (x - places[j]) for x in others]))
    return total
