"""Targets that are reached at the edge of what is known: ``python -m experiments.reached``.

Hidden designs in the corners and along the edges of the forward model's ranges are simulated, and
their apexes are targets: what inverse design calls unreachable is wrong. Prints one JSON object.
"""

import argparse
import json
from dataclasses import replace

import numpy as np

from snapjump.batch import simulate_designs
from snapjump.composition import with_tier
from snapjump.inverse.physics import PhysicsOptions
from snapjump.learning import STANDARD
from snapjump.learning.forward_model import ForwardModel, forward_model
from snapjump.plan.base import stretched
from snapjump.targets.answer import answer
from snapjump.targets.design import problem_of
from snapjump.targets.warm_up import warm_up

NEAR = 0.01  # of a range
EDGE = (0.32, 0.58)  # mass_bar and mu of the robots along edges


def main() -> None:
    """Count the targets that are not reached, in the corners and along the edges."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--corners", type=int, default=200)
    parser.add_argument("--edges", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    random = np.random.default_rng(given.seed)
    forward = forward_model(STANDARD)
    near = NEAR * random.random((given.corners, 4))
    corners = np.where(random.random((given.corners, 4)) < 0.5, near, 1.0 - near)
    edges = random.random((given.edges, 4))
    at, side = random.integers(0, 2, given.edges), random.random(given.edges) < 0.5
    close = NEAR * random.random(given.edges)
    edges[np.arange(given.edges), at] = np.where(side, close, 1.0 - close)
    hidden = stretched(edges, forward.ranges)
    hidden[:, 2:] = EDGE
    told = {"corners": told_of(forward, stretched(corners, forward.ranges))}
    print(json.dumps({**told, "edges": told_of(forward, hidden)}, indent=2))


def told_of(forward: ForwardModel, hidden: np.ndarray) -> dict[str, float]:
    """How many targets of hidden designs (N, 4) were not reached, and what the search cost."""
    base, method = with_tier("standard"), PhysicsOptions()
    targets = simulate_designs(base, hidden).apexes
    warm_up(base, forward, method)
    found = []
    for k, (target, design) in enumerate(zip(targets, hidden, strict=True)):
        environment = replace(base.environment, mass_bar=float(design[2]), mu=float(design[3]))
        robot = replace(base, environment=environment)
        found.append(answer(problem_of(robot, target, forward, forward, k), method))
    misses = [one.solutions[0].miss_bar(one.problem.target) for one in found]
    return {
        "targets": len(found),
        "not_reached": sum(not one.reachable for one in found),
        "median_miss_bar": float(np.median(misses)),
        "largest_miss_bar": float(max(misses)),
        "mean_simulations": float(np.mean([one.simulations for one in found])),
        "most_simulations": max(one.simulations for one in found),
        "median_seconds": float(np.median([one.seconds for one in found])),
    }


if __name__ == "__main__":
    main()
