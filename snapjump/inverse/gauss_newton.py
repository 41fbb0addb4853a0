"""``inverse=gauss_newton``: the forward model's own roots, to rounding."""

import numpy as np
from scipy.ndimage import minimum_filter

from snapjump.declare.fields import integer
from snapjump.inverse.base import (
    REACHED_BAR,
    Array,
    ForwardModel,
    InverseOptions,
    Problem,
    Solution,
    predicted_solutions,
)

MOST_STARTS = 24
SHORTEST = 1.0e-5  # step that is worth another one, as a share of the ranges
# Levenberg's damping, as a share of the largest curvature: first, least, and given up.
FIRST, LEAST, LARGEST = 1.0e-6, 1.0e-9, 1.0e4


class GaussNewtonOptions(InverseOptions):
    """Damped Gauss-Newton on the forward model, from a grid of its predictions."""

    points: int = integer(21, least=3, most=1000)
    iterations: int = integer(30, least=1, most=10_000)

    def solve(self, problem: Problem) -> list[Solution]:
        """All solutions that a grid of predictions can tell apart."""
        forward = problem.known_forward("gauss_newton")
        controls = problem.grid(self.points)
        designs = problem.designs(controls.reshape(-1, 2))
        apexes = forward.predict(designs).reshape(controls.shape)
        starts = linear_preimages(controls, apexes, problem.target)[:MOST_STARTS]
        found, misses = descend(problem, forward, starts, self.iterations)
        if not (misses <= REACHED_BAR).any():
            # Beyond the region that the grid makes out, or where it folds: from the nearest apexes.
            starts = nearest_points(controls, apexes, problem.target)[:MOST_STARTS]
            more, _ = descend(problem, forward, starts, self.iterations)
            found = np.vstack([found, more])
        return predicted_solutions(problem, forward, found)


def nearest_points(controls: Array, apexes: Array, target: Array) -> Array:
    """Controls (S, 2) of grids (n, n, 2) whose apexes are nearer than their neighbours', sorted."""
    misses = np.hypot(*np.moveaxis(apexes - target, -1, 0))
    lowest = misses <= minimum_filter(misses, size=3, mode="nearest")
    found: Array = controls[lowest][np.argsort(misses[lowest])]
    return found


def grid_triangles(grid: Array) -> Array:
    """Both halves of every cell of a grid (n, n, 2): (2 (n - 1)^2, 3, 2)."""
    lower = [grid[:-1, :-1], grid[1:, :-1], grid[:-1, 1:]]
    upper = [grid[1:, 1:], grid[:-1, 1:], grid[1:, :-1]]
    halves = [np.stack(corners, axis=-2).reshape(-1, 3, 2) for corners in (lower, upper)]
    return np.concatenate(halves)


def linear_preimages(controls: Array, apexes: Array, target: Array) -> Array:
    """Controls (S, 2) that the triangles of grids (n, n, 2), mapped linearly, send to a target."""
    images, sources = grid_triangles(apexes), grid_triangles(controls)
    first, second = images[:, 1] - images[:, 0], images[:, 2] - images[:, 0]
    way = target - images[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):  # a triangle may be mapped to a line
        a = cross(way, second) / cross(first, second)
        b = cross(first, way) / cross(first, second)
        holds = (a >= 0.0) & (b >= 0.0) & (a + b <= 1.0)
    a, b, held = a[holds, None], b[holds, None], sources[holds]
    found: Array = (1.0 - a - b) * held[:, 0] + a * held[:, 1] + b * held[:, 2]
    return found


def cross(first: Array, second: Array) -> Array:
    """Cross products (T,) of plane vectors (T, 2)."""
    product: Array = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    return product


def descend(
    problem: Problem, forward: ForwardModel, starts: Array, iterations: int
) -> tuple[Array, Array]:
    """Controls (S, 2) of least miss near the starts (S, 2), within the bounds, and misses (S,)."""
    span = problem.high - problem.low
    if not len(starts):
        return starts, np.zeros(0)
    shares = problem.scaled(starts)
    missed = forward.predict(problem.designs(starts)) - problem.target
    misses = np.hypot(*missed.T)
    damping = np.full(len(starts), FIRST)
    active = np.arange(len(starts))
    for _ in range(iterations):
        controls = problem.unscaled(shares[active])
        slopes = forward.jacobian(problem.designs(controls))[:, :, :2] * span
        trial = np.clip(shares[active] + steps(slopes, missed, damping, shares[active]), 0.0, 1.0)
        found = forward.predict(problem.designs(problem.unscaled(trial))) - problem.target
        better = np.hypot(*found.T) < np.hypot(*missed.T)
        moved = np.abs(trial - shares[active]).max(axis=1)
        shares[active[better]] = trial[better]
        missed = np.where(better[:, None], found, missed)
        misses[active] = np.hypot(*missed.T)
        damping = np.where(better, np.maximum(0.1 * damping, LEAST), 30.0 * damping)
        goes_on = (moved > SHORTEST) & (damping < LARGEST)
        active, missed, damping = active[goes_on], missed[goes_on], damping[goes_on]
        if not len(active):
            break
    return problem.unscaled(shares), misses


def steps(slopes: Array, missed: Array, damping: Array, shares: Array) -> Array:
    """Damped Gauss-Newton steps (S, 2); a control whose descent leads out of bounds stays."""
    gradient = np.einsum("sij,si->sj", slopes, missed)
    held = ((shares <= 0.0) & (gradient > 0.0)) | ((shares >= 1.0) & (gradient < 0.0))
    free = np.where(held[:, None, :], 0.0, slopes)
    matrix = np.einsum("sij,sik->sjk", free, free)
    largest = np.maximum(np.trace(matrix, axis1=1, axis2=2), 1e-300)
    matrix[:, [0, 1], [0, 1]] += (damping * largest)[:, None]
    found: Array = -np.linalg.solve(matrix, np.where(held, 0.0, gradient)[..., None])[..., 0]
    return found
