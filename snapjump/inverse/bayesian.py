"""``inverse=bayesian``: Bayesian optimisation on the simulator, one of the paper's comparisons."""

from contextlib import redirect_stdout
from typing import ClassVar

import numpy as np
from bayes_opt import BayesianOptimization
from threadpoolctl import threadpool_limits

from snapjump.checks import check_integer
from snapjump.declare.fields import integer
from snapjump.inverse.base import CONTROLS, InverseOptions, Problem, Search, Solution


class BayesianOptions(InverseOptions):
    """Bayesian optimisation of the simulated miss."""

    simulations: int = integer(60, least=1, most=100_000)
    first: int = 16
    needs_forward: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("inverse.first", self.first, 1, self.simulations)

    @threadpool_limits.wrap(limits=1)  # several wait for each other over matrices as small as these
    def solve(self, problem: Problem) -> list[Solution]:
        """The best of all simulated designs: ``first`` random ones, then one after the other."""
        how = {"random_state": problem.seed, "verbose": 0, "allow_duplicate_points": True}
        optimizer = BayesianOptimization(None, dict.fromkeys(CONTROLS, (0.0, 1.0)), **how)
        search = Search(problem, problem.simulator)
        # What does not jump is farther away than the start.
        farthest = 1.0 + float(np.hypot(*problem.target))
        shares = np.random.default_rng(problem.seed).random((self.first, 2))
        for left in range(self.simulations - self.first, -1, -1):
            misses = np.nan_to_num(problem.misses(search.simulate(shares)), nan=farthest)
            with redirect_stdout(None):  # where it says of every design tried again that it is one
                for share, miss in zip(shares, misses.tolist(), strict=True):
                    optimizer.register(dict(zip(CONTROLS, share, strict=True)), -miss)
            if left:
                suggested = optimizer.suggest()
                shares = np.array([[suggested[name] for name in CONTROLS]])
        return [search.best()]
