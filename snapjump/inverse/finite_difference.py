"""``inverse=finite_difference``: descent on the simulator, one of the paper's comparisons."""

from contextlib import suppress
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from scipy.optimize import Bounds, minimize

from snapjump.arrays import Array
from snapjump.declare.fields import integer, number
from snapjump.inverse.base import InverseOptions, Problem, Search, Solution

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
        search = Search(problem, problem.simulator)
        squared_miss = SquaredMiss(search, self.simulations, self.step)
        ticks = (np.arange(SIDE) + 0.5) / SIDE
        grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 2)
        start = grid[int(np.argmin(squared_miss.at(grid)))]
        with suppress(BudgetSpentError):
            minimize(squared_miss, start, jac=True, method="L-BFGS-B", bounds=Bounds(0.0, 1.0))
        return [search.best()]


@dataclass
class SquaredMiss:
    """The squared miss and its gradient by central differences, of shares of the ranges.

    ``left``: simulations that may still be made; ``step``: of a difference, as a share of a range:
    large enough for the simulator's roughness.
    """

    search: Search
    left: int
    step: float

    def at(self, shares: Array) -> Array:
        """Squared misses (N,) of shares (N, 2)."""
        self.left -= len(shares)
        if self.left < 0:
            raise BudgetSpentError
        target = self.search.problem.target
        squares: Array = np.sum((self.search.simulate(shares) - target) ** 2, axis=1)
        # What does not jump is farther away than the start.
        return np.nan_to_num(squares, nan=1.0 + float(np.sum(target**2)))

    def __call__(self, share: Array) -> tuple[float, Array]:
        """Value and gradient; differences are one-sided where the range ends."""
        around = np.clip(share + self.step * DIRECTIONS, 0.0, 1.0)
        squares = self.at(around)
        widths = np.array([around[1, 0] - around[2, 0], around[3, 1] - around[4, 1]])
        return float(squares[0]), (squares[[1, 3]] - squares[[2, 4]]) / widths
