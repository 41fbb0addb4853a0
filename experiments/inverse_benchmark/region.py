"""Errors of the decision whether a target can be reached, against the simulated region."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import shapely

from snapjump.arrays import Array
from snapjump.composition import Simulation
from snapjump.inverse.physics import PhysicsOptions
from snapjump.plan.base import Range, stretched
from snapjump.run.studies.base import Row
from snapjump.targets.answer import answer
from snapjump.targets.region import AchievableRegion
from snapjump.targets.simulator import JumpSimulator

from ..compositions import composed
from .compute import make_problem, opened

POINTS = 49  # of the simulated grid of controls, per control; mismatches of both signs
MARGIN = 0.1  # of the region's extent, that targets may lie beyond it
TARGETS = 25  # in an environment


@dataclass(frozen=True)
class Simulated:
    """A simulator in the place of a forward model, as far as a region asks it."""

    simulator: JumpSimulator
    ranges: tuple[Range, Range, Range, Range]

    def predict(self, designs: Array) -> Array:
        """Apexes (N, 2) in L. Raises RuntimeError if a robot does not jump."""
        apexes = self.simulator.apexes(designs)
        if not np.isfinite(apexes).all():
            raise RuntimeError("a design of the region's grid did not jump")
        return apexes


def region_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each environment: how many of its random targets were decided wrongly.
    The truth is the region of simulated apexes; a decision is that of ``task=inverse``."""
    forward, base = opened(inputs["checkpoint"]), composed(inputs["groups"])
    return [
        one_environment(forward, base, inputs["seed"], k)
        for k in range(inputs["first"], inputs["last"])
    ]


def one_environment(forward: Any, base: Simulation, seed: int, k: int) -> Row:
    """Environment number k of a seed."""
    rng = np.random.default_rng([seed, k, 1])
    hidden = stretched(rng.random((1, 4)), forward.ranges)[0]
    problem = make_problem(np.zeros(2), hidden, forward, base, k)
    simulated: Any = Simulated(JumpSimulator(base), forward.ranges)
    both_sides = replace(problem, low=np.array([-problem.high[0], problem.low[1]]))
    truth = AchievableRegion.of(both_sides, simulated, POINTS)
    low, high = truth.apexes.min(axis=(0, 1)), truth.apexes.max(axis=(0, 1))
    targets = low + (high - low) * ((1.0 + 2.0 * MARGIN) * rng.random((TARGETS, 2)) - MARGIN)
    targets[:, 1] = np.maximum(targets[:, 1], 0.0)
    reachable = truth.contains(targets)
    method = PhysicsOptions()
    accepted = np.array(
        [
            bool(answer(make_problem(target, hidden, forward, base, k), method).reachable)
            for target in targets
        ]
    )
    edge = shapely.distance(truth.outline().boundary, shapely.points(targets))
    wrong = accepted != reachable
    return {
        "mass_bar": float(hidden[2]),
        "mu": float(hidden[3]),
        "targets": TARGETS,
        "reachable": int(reachable.sum()),
        "false_accepts": int((accepted & ~reachable).sum()),
        "false_rejects": int((~accepted & reachable).sum()),
        "farthest_wrong_bar": float(edge[wrong].max()) if wrong.any() else 0.0,
    }
