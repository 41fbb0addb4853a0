"""``inverse=bayesian``: Bayesian optimisation on the simulator, one of the paper's comparisons."""

from typing import ClassVar

import numpy as np
from bayes_opt import BayesianOptimization

from snapjump.checks import check_integer
from snapjump.declare.fields import integer
from snapjump.inverse.base import CONTROLS, Array, InverseOptions, Problem, Solution


class BayesianOptions(InverseOptions):
    """Bayesian optimisation of the simulated miss."""

    simulations: int = integer(60, least=1, most=100_000)
    first: int = 16
    needs_forward: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("inverse.first", self.first, 1, self.simulations)

    def solve(self, problem: Problem) -> list[Solution]:
        """The best of all simulated designs: ``first`` random ones, then one after the other."""
        search = BayesianOptimization(
            None,
            {name: (0.0, 1.0) for name in CONTROLS},
            random_state=problem.seed,
            verbose=0,
            allow_duplicate_points=True,
        )
        begun = np.random.default_rng(problem.seed).random((self.first, 2))
        shares, apexes = begun, simulated(problem, begun)
        for share, apex in zip(shares, apexes, strict=True):
            search.register(dict(zip(CONTROLS, share, strict=True)), -miss_bar(problem, apex))
        while len(shares) < self.simulations:
            suggested = search.suggest()
            share = np.array([[suggested[name] for name in CONTROLS]])
            apex = simulated(problem, share)
            search.register(suggested, -miss_bar(problem, apex[0]))
            shares, apexes = np.vstack([shares, share]), np.vstack([apexes, apex])
        best = int(np.argmin([miss_bar(problem, apex) for apex in apexes]))
        apex = apexes[best] if np.isfinite(apexes[best]).all() else np.full(2, np.inf)
        return [Solution(problem.unscaled(shares[best]), apex, True)]


def simulated(problem: Problem, shares: Array) -> Array:
    """Apexes (N, 2) of shares (N, 2)."""
    return problem.simulator.apexes(problem.designs(problem.unscaled(shares)))


def miss_bar(problem: Problem, apex: Array) -> float:
    """Distance of an apex (2,) from the target, in L; without a jump more than from the start."""
    if not np.isfinite(apex).all():
        return 1.0 + float(np.hypot(*problem.target))
    return float(np.hypot(*(apex - problem.target)))
