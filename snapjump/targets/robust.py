"""Robust designs: the least expected miss when no parameter is quite what it should be."""

import time
from dataclasses import astuple, dataclass

import numpy as np
from scipy.optimize import minimize
from scipy.special import ndtr, ndtri
from scipy.stats import qmc

from snapjump.arrays import Array
from snapjump.declare.fields import Part, number
from snapjump.inverse.base import ForwardModel, Problem, Solution

SAMPLES, REPORTED = 256, 2048  # powers of two, as Sobol's points ask for
MOST_STARTS = 6
FIRST_STEP = 0.05  # of the descent, as a share of the ranges
LARGEST = 1.0e3  # of a standard deviation


class Tolerance(Part):
    """Standard deviations of the parameters as built and met, each normal about its nominal value
    and cut off where the forward model's range ends."""

    group = "tolerance"

    delta_alpha_rad: float = number(0.002, least=0.0, most=LARGEST)
    epsilon: float = number(0.001, least=0.0, most=LARGEST)
    mass_bar: float = number(0.01, least=0.0, most=LARGEST)
    mu: float = number(0.02, least=0.0, most=LARGEST)

    @property
    def deviations(self) -> Array:
        return np.array(astuple(self))


@dataclass(frozen=True)
class Scatter:
    """The distribution of the apexes (S, 2), in L, of robots of one design.

    ``mean``, ``deviation`` (2,): of them; ``expected_miss_bar``: mean distance from the target;
    ``radius90_bar``: of the circle about the target that holds 90 % of them.
    """

    apexes: Array
    mean: Array
    deviation: Array
    expected_miss_bar: float
    radius90_bar: float


@dataclass(frozen=True)
class Comparison:
    """A design that allows for the tolerances, and the seconds that it took, beside one that only
    aims."""

    seconds: float
    robust: Solution
    robust_scatter: Scatter
    plain: Solution
    plain_scatter: Scatter


def compare(problem: Problem, tolerance: Tolerance, solutions: list[Solution]) -> Comparison:
    """The robust design that solutions lead to, beside the first of these."""
    begun, forward = time.perf_counter(), problem.known_forward("robust")
    robust = robust_solution(problem, forward, tolerance, solutions)
    seconds = time.perf_counter() - begun
    pair = robust, solutions[0]
    ours, plain = (scatter(problem, forward, tolerance, one.controls) for one in pair)
    return Comparison(seconds, robust, ours, solutions[0], plain)


def sobol_points(count: int, seed: int) -> Array:
    """Points (count, 4) of the open unit cube; the same for the same seed."""
    points: Array = qmc.Sobol(4, rng=seed).random(count)
    return np.clip(points, 1e-9, 1.0 - 1e-9)


def built(
    problem: Problem, forward: ForwardModel, tolerance: Tolerance, controls: Array, points: Array
) -> Array:
    """Designs (S, 4) that become of nominal controls (2,), one a point (S, 4) of the unit cube."""
    nominal = problem.designs(controls[None, :])[0]
    low, high = np.array(forward.ranges).T
    deviations = np.maximum(tolerance.deviations, 1e-12 * (high - low))
    below, above = ndtr((low - nominal) / deviations), ndtr((high - nominal) / deviations)
    designs: Array = nominal + deviations * ndtri(below + points * (above - below))
    return np.clip(designs, low, high)


def scatter(
    problem: Problem, forward: ForwardModel, tolerance: Tolerance, controls: Array
) -> Scatter:
    """The distribution of a design's apex, from samples that no design was chosen by."""
    points = sobol_points(REPORTED, problem.seed + 1)
    apexes = forward.predict(built(problem, forward, tolerance, controls, points))
    misses = problem.misses(apexes)
    expected, radius90 = float(misses.mean()), float(np.quantile(misses, 0.9))
    return Scatter(apexes, apexes.mean(axis=0), apexes.std(axis=0), expected, radius90)


def robust_solution(
    problem: Problem, forward: ForwardModel, tolerance: Tolerance, solutions: list[Solution]
) -> Solution:
    """The design of least expected miss (not squared) that descents from solutions lead to.

    The samples are the same for all designs, so that the expectation is a smooth function of them.
    """
    points = sobol_points(SAMPLES, problem.seed)

    def expected_miss(share: Array) -> float:
        controls = problem.unscaled(share)
        apexes = forward.predict(built(problem, forward, tolerance, controls, points))
        return float(problem.misses(apexes).mean())

    found = []
    for solution in solutions[:MOST_STARTS]:
        start = problem.scaled(solution.controls)
        inwards = np.diag(np.where(start > 0.5, -FIRST_STEP, FIRST_STEP))
        simplex = np.vstack([start, start + inwards])
        how = {"initial_simplex": simplex, "xatol": 1e-4, "fatol": 1e-5}
        box = [(0.0, 1.0)] * 2
        found.append(minimize(expected_miss, start, method="Nelder-Mead", bounds=box, options=how))
    best = min(found, key=lambda result: float(result.fun))
    controls = problem.unscaled(best.x)
    return Solution(controls, forward.predict(problem.designs(controls[None, :]))[0], False)
