"""``inverse=physics``: the simulator has the last word.

Gauss-Newton steps start from the forward model's solutions, in rounds of several candidates that
fill the lanes of the simulator: one aims at the target, the others around it.

``slopes=fitted``: the derivative is a fit to all that was simulated nearby, drawn to the forward
model's (without one, a grid of simulations comes first). ``slopes=exact``: it is the simulator's
own at the best point so far, and the candidates are steps of several lengths. The converged map
has wrinkles of 0.01 L and every tier some roughness besides; an exact derivative is that of a
wrinkle, a fit sees over it. The benchmark compares both.
"""

from collections.abc import Callable, Iterator
from typing import ClassVar

import numpy as np
from scipy.optimize import lsq_linear

from snapjump.arrays import Array
from snapjump.declare.fields import choice, integer, number
from snapjump.inverse.base import REACH_BAR, InverseOptions, Problem, Search, Solution
from snapjump.inverse.gauss_newton import GaussNewtonOptions, nearest_points

CANDIDATES = 8  # a round: as many as the simulator has lanes
SLOPES = ("fitted", "exact")
FINISHING = ("same", "reference")
SIDE = 8  # of the grid of simulations that begins a search without forward model
LONGEST_STEP = 0.25  # of a control's range
MOST_MORE, APART = 6, 0.1  # further starts, and how far from each other, as a share of the ranges
PATIENCE, STALLED = 4, 0.99  # rounds, and the share of a miss that is left of it after so many
# Distance of the aims around the target: at first that of a forward model's error, then a share of
# the miss, and never less than what roughness makes of any aim. In L.
FIRST_RING_BAR, RING_SHARE, LEAST_RING_BAR = 0.02, 0.25, 2.0e-4
ROUGHNESS_BAR = 1.0e-3  # of a simulated apex, against which slopes are fitted
TRUST = 0.3  # relative error of the slopes that the fit is drawn to
NEAREST = 24  # points of a fit, the nearest to the target
CLOSE_BAR = 2.0e-3  # misses below this weigh alike in a fit
DIFFERENCES = (0.01, 0.04, 0.003)  # of a control's range: wider than wrinkles, and not
Rounds = Callable[[Search, Solution], Iterator[Solution]]
LENGTHS = np.array([1.5, 1.2, 1.0, 0.8, 0.5, 0.25, 0.1, 0.03])  # of exact steps


class PhysicsOptions(InverseOptions):
    """Gauss-Newton on the simulator, from the forward model's solutions."""

    needs_forward: ClassVar[bool] = False

    slopes: str = choice("fitted", SLOPES)
    finishing: str = choice("same", FINISHING)
    tolerance_bar: float = number(3.0e-4, above=0.0, most=1.0)
    most_simulations: int = integer(160, least=CANDIDATES, most=100_000)

    @property
    def needs_slopes(self) -> bool:
        return self.slopes == "exact"

    def solve(self, problem: Problem) -> list[Solution]:
        """The best refined solution, then those of the forward model that were not needed."""
        search = Search(problem, problem.simulator)
        starts = first_guesses(search)
        tried, refined = list(starts), list[Solution]()
        while starts and not any(self._reaches(problem, one) for one in refined):
            refined.append(self._refined(search, starts.pop(0)))
            search = Search(problem, problem.simulator)
            if not starts and len(tried) <= MOST_MORE and least_miss(problem, refined) > REACH_BAR:
                starts = other_guesses(problem, tried)[:1]
                tried += starts
        # A fit may be led astray by wrinkles: before a target is given up, plain differences.
        for start in [*tried, min(refined, key=lambda one: one.miss_bar(problem.target))]:
            if self.needs_slopes or least_miss(problem, refined) <= REACH_BAR:
                break
            search = Search(problem, problem.simulator)
            refined.append(self._followed(search, start, differenced_rounds))
        # Starts that led nowhere are no solutions; those that were not tried may be.
        return [min(refined, key=lambda one: one.miss_bar(problem.target)), *starts]

    def _reaches(self, problem: Problem, solution: Solution) -> bool:
        return solution.miss_bar(problem.target) <= self.tolerance_bar

    def _refined(self, search: Search, start: Solution) -> Solution:
        """Refined at the problem's tier, then at the finer one if that is to have the last word."""
        rounds = exact_rounds if self.needs_slopes else fitted_rounds
        problem, searches = search.problem, [search]
        if self.finishing != "same":
            searches.append(Search(problem, problem.simulator.at(self.finishing)))
        for search in searches:
            start = self._followed(search, start, rounds)
        return start

    def _followed(self, search: Search, start: Solution, rounds: Rounds) -> Solution:
        """The best point of a search, which ends where it has reached the target, may not go on, or
        gets no nearer."""
        allowed = search.simulator.simulations + self.most_simulations - CANDIDATES
        misses: list[float] = []
        for best in rounds(search, start):
            misses.append(best.miss_bar(search.problem.target))
            ended = self._reaches(search.problem, best) or search.simulator.simulations > allowed
            if ended or stalled(misses):
                break
        return best


def first_guesses(search: Search) -> list[Solution]:
    """The forward model's solutions, or without one the best point of a grid of simulations."""
    if search.problem.forward is not None:
        return GaussNewtonOptions().solve(search.problem)
    search.simulate(search.problem.scaled(search.problem.grid(SIDE).reshape(-1, 2)))
    return [search.best()]


def other_guesses(problem: Problem, tried: list[Solution]) -> list[Solution]:
    """Where else the forward model comes nearer than all about, the nearest first; far from what
    was tried."""
    if problem.forward is None:
        return []
    grid = problem.grid(GaussNewtonOptions().points)
    apexes = problem.forward.predict(problem.designs(grid.reshape(-1, 2))).reshape(grid.shape)
    known = problem.scaled(np.array([one.controls for one in tried]))
    return [
        Solution(controls, problem.forward.predict(problem.designs(controls[None]))[0], False)
        for controls in nearest_points(grid, apexes, problem.target)
        if np.abs(known - problem.scaled(controls)).max(axis=1).min() > APART
    ]


def least_miss(problem: Problem, solutions: list[Solution]) -> float:
    """The least distance of their apexes from the target, in L."""
    return min(one.miss_bar(problem.target) for one in solutions)


def stalled(misses: list[float]) -> bool:
    """Whether the least misses, one a round, no longer shrink and are far from a reached target."""
    if len(misses) <= PATIENCE or misses[-1] <= REACH_BAR:
        return False
    return misses[-1] > STALLED * misses[-1 - PATIENCE]


def by_shares(problem: Problem, slopes: Array) -> Array:
    """Derivatives (2, 2) of the apex by the shares, from those (1, 2, 4) by the design."""
    found: Array = slopes[0, :, :2] * (problem.high - problem.low)
    return found


def step(slopes: Array, change: Array, shares: Array) -> Array:
    """The step (2) from the shares that changes the apex so, as far as bounds let it."""
    room = np.maximum(np.stack([shares, 1.0 - shares]), 1e-12)
    way = lsq_linear(slopes, change, bounds=(-room[0], room[1])).x
    return np.clip(way, -LONGEST_STEP, LONGEST_STEP)


def fitted_rounds(search: Search, start: Solution) -> Iterator[Solution]:
    """The best point after each round; slopes are fitted to what was simulated."""
    forward, target = search.problem.forward, search.problem.target
    here = search.problem.scaled(start.controls)
    believed = start.apex if np.isfinite(start.apex).all() else target
    drawn_to = np.eye(2) * max(1.0, float(np.abs(target).max()))
    if forward is not None:
        drawn_to = by_shares(search.problem, forward.jacobian(search.designs(here[None])))
    slopes = drawn_to
    if len(search.apexes):
        here, believed, slopes = fit(search, drawn_to)
    ring = max(FIRST_RING_BAR, RING_SHARE * float(np.hypot(*(believed - target))))
    turn = 2.0 * np.pi * np.arange(CANDIDATES - 1) / (CANDIDATES - 1)
    around = np.vstack([np.zeros(2), np.column_stack([np.cos(turn), np.sin(turn)])])
    while True:
        change = target - believed
        steps = [step(slopes, change + ring * aim, here) for aim in around]
        search.simulate(np.clip(here + steps, 0.0, 1.0))
        yield search.best()
        if len(search.apexes):
            here, believed, slopes = fit(search, drawn_to)
            ring = max(LEAST_RING_BAR, RING_SHARE * float(search.misses().min()))


def fit(search: Search, drawn_to: Array) -> tuple[Array, Array, Array]:
    """Middle (2) of the points nearest to the target, their mean apex (2), and slopes (2, 2).
    Ridge regression, drawn to given slopes as far as roughness leaves the points undecided."""
    misses = search.misses()
    nearest = np.argsort(misses)[:NEAREST]
    weights = 1.0 / (misses[nearest] + CLOSE_BAR)
    weights /= weights.sum()
    middle, mean = weights @ search.shares[nearest], weights @ search.apexes[nearest]
    inputs, outputs = search.shares[nearest] - middle, search.apexes[nearest] - mean
    stiffness = (ROUGHNESS_BAR / (TRUST * np.linalg.norm(drawn_to))) ** 2
    normal = inputs.T @ (weights[:, None] * inputs) + stiffness * np.eye(2)
    unexplained = outputs - inputs @ drawn_to.T
    correction = np.linalg.solve(normal, inputs.T @ (weights[:, None] * unexplained))
    return middle, mean, drawn_to + correction.T


def exact_rounds(search: Search, start: Solution) -> Iterator[Solution]:
    """The best point after each round; slopes are the simulator's own."""

    def slopes(here: Array) -> Array:
        return by_shares(search.problem, search.simulator.slopes(search.designs(here[None])))

    return sloped_rounds(search, start, slopes)


def differenced_rounds(search: Search, start: Solution) -> Iterator[Solution]:
    """The best point after each round; slopes are differences of simulations around it, over other
    distances where those of one lead no further."""
    for distance in DIFFERENCES:

        def slopes(here: Array, distance: float = distance) -> Array:
            ends = [np.clip(here + sign * distance * np.eye(2), 0.0, 1.0) for sign in (1.0, -1.0)]
            apexes = search.simulate(np.vstack(ends))
            found: Array = (apexes[:2] - apexes[2:]).T / np.diag(ends[0] - ends[1])
            return found

        yield from sloped_rounds(search, start, slopes)
        start = search.best()


def sloped_rounds(
    search: Search, start: Solution, slopes_at: Callable[[Array], Array]
) -> Iterator[Solution]:
    """The best point after each round of steps of several lengths along slopes (2, 2) by shares;
    ends where no step is an improvement."""
    search.simulate(search.problem.scaled(start.controls)[None])
    best = search.best()
    yield best
    while True:
        here = search.problem.scaled(best.controls)
        slopes = slopes_at(here)
        if not np.isfinite(slopes).all():
            return
        way = step(slopes, search.problem.target - best.apex, here)
        search.simulate(np.clip(here + LENGTHS[:, None] * way, 0.0, 1.0))
        if search.best().miss_bar(search.problem.target) >= best.miss_bar(search.problem.target):
            return
        best = search.best()
        yield best
