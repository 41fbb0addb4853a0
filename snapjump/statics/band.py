"""Symmetric band matrices: factors, solutions, quadratic forms, the smallest eigenvalue.

In plain loops, compiled once: what LAPACK returns depends on the processor in its last bits, and
for slender arches its eigenvalues are some fifty times less accurate than the Rayleigh quotient
of :func:`smallest_eigenvalue`. A matrix is a lower band (n, 6): ``band[j, k]`` is the entry of row
j + k and column j; what would lie below the last row is not read.
"""

from typing import Any

import numpy as np

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.number.dispatch import compiled, routine

WIDTH = HALF_BANDWIDTH + 1
ROUNDING = 2.0**-52
BISECTIONS = 24
INVERSE_ITERATIONS = 8


@routine
def factor(band: Any, shift: float, factors: Any) -> int:
    """L D L^T of ``band`` less ``shift`` on its diagonal; returns how many pivots are negative.

    That is the number of eigenvalues below the shift. ``factors`` (n, 6) holds D and the columns
    of L below its diagonal. Without pivoting: the arch's leading blocks are those of shorter
    arches, which are stiffer.
    """
    size = band.shape[0]
    negative = 0
    for j in range(size):
        for k in range(min(WIDTH, size - j)):
            value = band[j, k]
            if k == 0:
                value -= shift
            for m in range(1, min(WIDTH - k, j + 1)):
                i = j - m
                value -= factors[i, m + k] * factors[i, m] * factors[i, 0]
            if k == 0:
                if value == 0.0:
                    value = ROUNDING * abs(band[j, 0])
                factors[j, 0] = value
                negative += value < 0.0
            else:
                factors[j, k] = value / factors[j, 0]
    return negative


@routine
def substitute(factors: Any, x: Any) -> None:
    """Replace a right-hand side (n) by the solution."""
    size = factors.shape[0]
    for j in range(size):
        for k in range(1, min(WIDTH, size - j)):
            x[j + k] -= factors[j, k] * x[j]
    for j in range(size - 1, -1, -1):
        x[j] /= factors[j, 0]
        for k in range(1, min(WIDTH, size - j)):
            x[j] -= factors[j, k] * x[j + k]


@compiled
def dot(a: Any, b: Any) -> float:
    """Sum of products, one after the other."""
    total = 0.0
    for i in range(a.shape[0]):
        total += a[i] * b[i]
    return total


@routine
def subtract_product(band: Any, x: Any, values: Any) -> None:
    """Subtract K x from ``values`` (n)."""
    size = band.shape[0]
    for j in range(size):
        values[j] -= band[j, 0] * x[j]
        for k in range(1, min(WIDTH, size - j)):
            values[j + k] -= band[j, k] * x[j]
            values[j] -= band[j, k] * x[j + k]


@routine
def quadratic_form(band: Any, x: Any) -> tuple[float, float]:
    """x K x, and the size of what rounding of the matrix's entries makes of it.

    Roundings of single entries add up like a random walk.
    """
    size = band.shape[0]
    value = 0.0
    squares = 0.0
    for j in range(size):
        row = 0.0
        for k in range(min(WIDTH, size - j)):
            term = band[j, k] * x[j + k]
            if k > 0:
                term *= 2.0
            row += term
            squares += (term * x[j]) ** 2
        value += row * x[j]
    return value, ROUNDING * np.sqrt(squares)


@compiled
def solve_bordered(
    band: Any, column: Any, row: Any, corner: float, right: Any, last: float
) -> tuple[Any, float]:
    """Solve [[K, column], [row, corner]] (x, z) = (right, last), K being the band (n, 6).

    K is eliminated as a block, and the result corrected once by its own residual: at a fold,
    where K alone is singular, the first one has lost digits (Govaerts 2000, chapter 3).
    """
    size = band.shape[0]
    factors = np.empty((size, WIDTH))
    factor(band, 0.0, factors)
    with_column = column.copy()
    substitute(factors, with_column)
    schur = corner - dot(row, with_column)
    x = np.zeros(size)
    z = 0.0
    for _ in range(2):
        change = right - z * column
        subtract_product(band, x, change)
        excess = last - dot(row, x) - corner * z
        substitute(factors, change)
        turn = (excess - dot(row, change)) / schur
        for i in range(size):
            x[i] += change[i] - turn * with_column[i]
        z += turn
    return x, z


@compiled
def smallest_eigenvalue(band: Any, vector: Any) -> tuple[float, float, int]:
    """Smallest eigenvalue, what rounding makes of it, and the number of negative eigenvalues.

    Bisection by the signs of pivots encloses it, inverse iteration from just below gives the unit
    ``vector`` (n), and its Rayleigh quotient the value: an error of the vector's enters squared.
    """
    size = band.shape[0]
    factors = np.empty((size, WIDTH))
    negative = factor(band, 0.0, factors)
    low, high = -1.0, 0.0
    if negative == 0:
        low, high = 0.0, 1.0
        while factor(band, high, factors) == 0:
            low, high = high, 2.0 * high
    while factor(band, low, factors) > 0:
        low, high = 2.0 * low, low
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if factor(band, middle, factors) == 0:
            low = middle
        else:
            high = middle
    factor(band, low - (high - low), factors)
    for i in range(size):
        vector[i] = 1.0 + i / size  # neither symmetric nor antisymmetric
    for _ in range(INVERSE_ITERATIONS):
        substitute(factors, vector)
        norm = 0.0
        for i in range(size):
            norm += vector[i] * vector[i]
        norm = np.sqrt(norm)
        for i in range(size):
            vector[i] /= norm
    value, rounding = quadratic_form(band, vector)
    return value, rounding, negative
