"""How far the achievable region can be trusted: ``python -m experiments.region`` prints figures.

Random targets about the regions of several environments are judged by the forward model, as
``task=inverse`` does it, and by simulations of a fine grid of designs.
"""

import json
import sys

import numpy as np
import shapely

from experiments.designs import spread_designs
from snapjump.composition import with_tier
from snapjump.inverse.base import Array, Problem
from snapjump.learning.forward_model import open_forward_model
from snapjump.targets.answer import out_of_reach
from snapjump.targets.region import AchievableRegion
from snapjump.targets.request import SHIPPED
from snapjump.targets.simulator import JumpSimulator

ENVIRONMENTS, TARGETS = 8, 250  # targets in each
POINTS = 41  # of the grid of simulated designs, per control
MARGIN = 0.1  # of the extent of the region, that targets lie beyond it


class SimulatedModel:
    """Simulations in the place of a forward model."""

    def __init__(self, simulator: JumpSimulator):
        self.predict = simulator.apexes


def main(checkpoint: str | None = None, tier: str = "standard") -> None:
    """Count the targets that are judged differently, and how far these are from the boundary."""
    forward = open_forward_model(checkpoint or SHIPPED)
    simulator = JumpSimulator(with_tier(tier))
    random = np.random.default_rng(0)
    low, high = np.array(forward.ranges[:2]).T
    accepted: list[float] = []
    rejected: list[float] = []
    for _, _, mass_bar, mu in spread_designs(ENVIRONMENTS):
        problem = Problem(np.zeros(2), mass_bar, mu, low, high, forward, simulator)
        truth = AchievableRegion.of(problem, SimulatedModel(simulator), POINTS)  # type: ignore[arg-type]
        targets = random_targets(truth.apexes.reshape(-1, 2), random)
        edge = truth.outline().boundary
        for target, reachable in zip(targets, truth.contains(targets), strict=True):
            moved = Problem(target, mass_bar, mu, low, high, forward, simulator)
            taken = out_of_reach(moved, forward) is None
            if taken != reachable:
                (accepted if taken else rejected).append(edge.distance(shapely.Point(target)))
    print(json.dumps(report(accepted, rejected), indent=2))


def random_targets(apexes: Array, random: np.random.Generator) -> Array:
    """Targets (TARGETS, 2) spread evenly over the box of the apexes and a margin about it."""
    low, high = apexes.min(axis=0), apexes.max(axis=0)
    margin = MARGIN * (high - low)
    return random.uniform(low - margin, high + margin, (TARGETS, 2))


def report(accepted: list[float], rejected: list[float]) -> dict[str, float]:
    """Shares of all targets, and distances from the simulated boundary in L."""
    total = ENVIRONMENTS * TARGETS
    found: dict[str, float] = {"targets": total}
    for name, distances in (("false_accept", accepted), ("false_reject", rejected)):
        found[f"{name}_percent"] = 100.0 * len(distances) / total
        found[f"{name}_median_distance_bar"] = float(np.median(distances)) if distances else 0.0
        found[f"{name}_largest_distance_bar"] = max(distances, default=0.0)
    return found


if __name__ == "__main__":
    main(*sys.argv[1:])
