"""``inverse=finite_difference``: descent on the simulator, one of the paper's comparisons."""

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from scipy.optimize import Bounds, minimize

from snapjump.declare.fields import integer, number
from snapjump.inverse.base import Array, InverseOptions, Problem, Solution

SIDE = 4  # of the grid of simulations that the search begins with
DIRECTIONS = np.array([[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])


class BudgetSpentError(Exception):
    """The next gradient would cost more simulations than there are left."""


class FiniteDifferenceOptions(InverseOptions):
    """Quasi-Newton descent (L-BFGS-B) on the simulated miss by finite differences."""

    simulations: int = integer(200, least=SIDE**2, most=1_000_000)
    step: float = number(0.01, above=0.0, most=0.5)
    needs_forward: ClassVar[bool] = False

    def solve(self, problem: Problem) -> list[Solution]:
        """The best of all simulated designs: those of a coarse grid, then a descent (L-BFGS-B)."""
        search = Descent(problem, self.simulations, self.step)
        ticks = (np.arange(SIDE) + 0.5) / SIDE
        grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 2)
        misses = search.simulate(grid)
        start = grid[int(np.argmin(misses))]
        try:
            minimize(search, start, jac=True, method="L-BFGS-B", bounds=Bounds(0.0, 1.0))
        except BudgetSpentError:
            pass
        return [search.best()]


@dataclass
class Descent:
    """The squared miss and its gradient by central differences, of shares of the ranges.

    ``step``: of a difference, as a share of a range: large enough for the simulator's roughness.
    """

    problem: Problem
    simulations: int
    step: float
    shares: Array = field(default_factory=lambda: np.zeros((0, 2)))
    apexes: Array = field(default_factory=lambda: np.zeros((0, 2)))

    def simulate(self, shares: Array) -> Array:
        """Squared misses (N,) of shares (N, 2), which are kept."""
        if len(self.shares) + len(shares) > self.simulations:
            raise BudgetSpentError
        designs = self.problem.designs(self.problem.unscaled(shares))
        apexes = self.problem.simulator.apexes(designs)
        self.shares = np.vstack([self.shares, shares])
        self.apexes = np.vstack([self.apexes, apexes])
        squares: Array = np.sum((apexes - self.problem.target) ** 2, axis=1)
        # What does not jump is farther away than the start.
        return np.nan_to_num(squares, nan=1.0 + float(np.sum(self.problem.target**2)))

    def __call__(self, share: Array) -> tuple[float, Array]:
        """Value and gradient; differences are one-sided where the range ends."""
        around = np.clip(share + self.step * DIRECTIONS, 0.0, 1.0)
        squares = self.simulate(around)
        widths = np.array([around[1, 0] - around[2, 0], around[3, 1] - around[4, 1]])
        return float(squares[0]), (squares[[1, 3]] - squares[[2, 4]]) / widths

    def best(self) -> Solution:
        """The simulated design with the least miss."""
        misses = np.hypot(*(self.apexes - self.problem.target).T)
        k = int(np.argmin(np.nan_to_num(misses, nan=np.inf)))
        apex = self.apexes[k] if np.isfinite(misses[k]) else np.full(2, np.inf)
        return Solution(self.problem.unscaled(self.shares[k]), apex, True)
