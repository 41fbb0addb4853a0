"""The lowest point of a beam, between its nodes."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.number.dispatch import compiled, routine

DEGREE = 5
# Nodes on either side that a spline's value is computed from: farther ones have less influence
# than rounding, 0.43 to this power of the difference that the end of the spline makes.
REACH = 15
NEWTON_STEPS = 8
AT_NODES = (1.0 / 120.0, 26.0 / 120.0, 66.0 / 120.0, 26.0 / 120.0, 1.0 / 120.0)
# Sixth differences: the fifth derivative's jumps at a knot.
JUMP = (1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0)


@routine
def solve_dense(matrix: Any, right: Any) -> None:
    """Replace a right-hand side by the solution, by elimination with partial pivoting."""
    size = right.shape[0]
    for j in range(size):
        pivot = j
        for i in range(j + 1, size):
            if abs(matrix[i, j]) > abs(matrix[pivot, j]):
                pivot = i
        for k in range(j, size):
            matrix[j, k], matrix[pivot, k] = matrix[pivot, k], matrix[j, k]
        right[j], right[pivot] = right[pivot], right[j]
        for i in range(j + 1, size):
            share = matrix[i, j] / matrix[j, j]
            for k in range(j, size):
                matrix[i, k] -= share * matrix[j, k]
            right[i] -= share * right[j]
    for j in range(size - 1, -1, -1):
        for k in range(j + 1, size):
            right[j] -= matrix[j, k] * right[k]
        right[j] /= matrix[j, j]


@routine
def spline_coefficients(heights: Any) -> Any:
    """Coefficients (N + 4) of the quintic B-splines about nodes -2 to N + 1 whose sum goes through
    the heights (N >= 6); the first and the last two inner knots are none (not-a-knot)."""
    nodes = heights.shape[0]
    size = nodes + 4
    matrix = np.zeros((size, size))
    found = np.zeros(size)
    for i in range(nodes):
        found[i] = heights[i]
        for k in range(5):
            matrix[i, i + k] = AT_NODES[k]
    for row in range(4):
        knot = row + 1 if row < 2 else nodes - 4 + row - 1
        for k in range(7):
            matrix[nodes + row, knot - 1 + k] = JUMP[k]
    solve_dense(matrix, found)
    return found


@routine
def spline_point(coefficients: Any, place: float) -> tuple[float, float, float]:
    """Value, slope and second derivative of the spline at a place, in steps from node 0."""
    nodes = coefficients.shape[0] - 4
    before = min(max(int(place), 0), nodes - 2)
    # De Boor's scheme for uniform knots, on six coefficients.
    t = place - before
    d = coefficients[before : before + 6].copy()
    slope = 0.0
    bend = 0.0
    for level in range(1, DEGREE + 1):
        if level == DEGREE - 1:
            bend = 10.0 * (d[2] - 2.0 * d[1] + d[0])
        if level == DEGREE:
            slope = 5.0 * (d[1] - d[0])
        span = DEGREE + 1 - level
        for k in range(span):
            share = (t - k + span - 1) / span
            d[k] = (1.0 - share) * d[k] + share * d[k + 1]
    return d[0], slope, bend


@compiled
def lowest_of_spline(heights: Any, place: float) -> float:
    """Height of the lowest point within a step of a place, by Newton's method for the slope."""
    coefficients = spline_coefficients(heights)
    first = place
    for _ in range(NEWTON_STEPS):
        _, slope, bend = spline_point(coefficients, place)
        place = min(max(place - slope / bend, first - 1.0), first + 1.0)
    return spline_point(coefficients, place)[0]


def lowest_height(heights: NDArray[np.float64]) -> float:
    """Height of the lowest point of the curve through nodes (N >= 6), in the unit of ``heights``.

    The curve is the quintic spline through all nodes, so that the height is a smooth function
    (four times differentiable) of theirs, whichever nodes the lowest point lies between.
    """
    lowest = int(np.argmin(heights))
    if lowest in (0, len(heights) - 1):
        return float(heights[lowest])
    first = max(lowest - REACH, 0)
    near = np.ascontiguousarray(heights[first : lowest + REACH + 1])
    return float(lowest_of_spline(near, float(lowest - first)))
