"""Symmetric banded elimination with a border: L D L^T over the nodes, then the frame's block.

The nodes' matrix has half-bandwidth 5; the frame's three coordinates couple to the nodes only
near the clamps but fill in, so they are kept as a border of three rows. Only the frame's own
3 x 3 block may be unsymmetric (friction at its feet): it is solved last, with pivoting by size
of the diagonal being unnecessary since its inertia dominates it.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import fma, where


@kernel
def eliminate_node_row(band: Any, x: Any, j: Any) -> Any:
    """Bring column j of the band and entry j of x up to date; returns the factors of the five
    columns before it, nearest first."""
    f1 = band[j - 1, 1] * band[j - 1, 0]
    f2 = band[j - 2, 2] * band[j - 2, 0]
    f3 = band[j - 3, 3] * band[j - 3, 0]
    f4 = band[j - 4, 4] * band[j - 4, 0]
    f5 = band[j - 5, 5] * band[j - 5, 0]
    # The column just before comes last everywhere: its pivot is the one still being computed.
    pivot = fma(-f5, band[j - 5, 5], band[j, 0])
    pivot = fma(-f4, band[j - 4, 4], pivot)
    pivot = fma(-f3, band[j - 3, 3], pivot)
    pivot = fma(-f2, band[j - 2, 2], pivot)
    pivot = fma(-f1, band[j - 1, 1], pivot)
    band[j, 0] = 1.0 / pivot
    value = fma(-f4, band[j - 4, 5], band[j, 1])
    value = fma(-f3, band[j - 3, 4], value)
    value = fma(-f2, band[j - 2, 3], value)
    band[j, 1] = fma(-f1, band[j - 1, 2], value)
    value = fma(-f3, band[j - 3, 5], band[j, 2])
    value = fma(-f2, band[j - 2, 4], value)
    band[j, 2] = fma(-f1, band[j - 1, 3], value)
    value = fma(-f2, band[j - 2, 5], band[j, 3])
    band[j, 3] = fma(-f1, band[j - 1, 4], value)
    band[j, 4] = fma(-f1, band[j - 1, 5], band[j, 4])
    value = fma(-f5, x[j - 5], x[j])
    value = fma(-f4, x[j - 4], value)
    value = fma(-f3, x[j - 3], value)
    value = fma(-f2, x[j - 2], value)
    x[j] = fma(-f1, x[j - 1], value)
    return f1, f2, f3, f4, f5


@kernel
def substitute_back(band: Any, x: Any, j: Any, value: Any) -> None:
    """Entry j of the solution, ``value`` being its right-hand side."""
    value = fma(-band[j, 1], x[j + 1], value)
    value = fma(-band[j, 2], x[j + 2], value)
    value = fma(-band[j, 3], x[j + 3], value)
    value = fma(-band[j, 4], x[j + 4], value)
    value = fma(-band[j, 5], x[j + 5], value)
    x[j] = value * band[j, 0]


@routine
def solve_nodes(system: Any) -> Any:
    """Solve without a frame."""
    band = system.padded_band
    x = system.padded_residual
    size = band.shape[0] - HALF_BANDWIDTH
    negative = 0.0 * band[0, 0]
    for j in range(HALF_BANDWIDTH, size):
        eliminate_node_row(band, x, j)
        negative = negative + where(band[j, 0] > 0.0, 0.0, 1.0)
    for j in range(size - 1, HALF_BANDWIDTH - 1, -1):
        substitute_back(band, x, j, x[j])
    return negative


@kernel
def eliminate_border_row(border: Any, j: Any, factors: Any) -> Any:
    """Bring column j of the border's three rows up to date and return it."""
    f1, f2, f3, f4, f5 = factors
    b0 = fma(-f5, border[j - 5, 0], border[j, 0])
    b0 = fma(-f4, border[j - 4, 0], b0)
    b0 = fma(-f3, border[j - 3, 0], b0)
    b0 = fma(-f2, border[j - 2, 0], b0)
    b0 = fma(-f1, border[j - 1, 0], b0)
    b1 = fma(-f5, border[j - 5, 1], border[j, 1])
    b1 = fma(-f4, border[j - 4, 1], b1)
    b1 = fma(-f3, border[j - 3, 1], b1)
    b1 = fma(-f2, border[j - 2, 1], b1)
    b1 = fma(-f1, border[j - 1, 1], b1)
    b2 = fma(-f5, border[j - 5, 2], border[j, 2])
    b2 = fma(-f4, border[j - 4, 2], b2)
    b2 = fma(-f3, border[j - 3, 2], b2)
    b2 = fma(-f2, border[j - 2, 2], b2)
    b2 = fma(-f1, border[j - 1, 2], b2)
    border[j, 0] = b0
    border[j, 1] = b1
    border[j, 2] = b2
    return b0, b1, b2


@routine
def solve_bordered(system: Any) -> Any:
    """Solve with a frame of three coordinates."""
    band = system.padded_band
    border = system.padded_border
    square = system.square
    x = system.frame_residual
    nodes = system.padded_residual
    size = band.shape[0] - HALF_BANDWIDTH
    negative = 0.0 * band[0, 0]
    for j in range(HALF_BANDWIDTH, size):
        factors = eliminate_node_row(band, nodes, j)
        b0, b1, b2 = eliminate_border_row(border, j, factors)
        inverse = band[j, 0]
        value = nodes[j]
        negative = negative + where(inverse > 0.0, 0.0, 1.0)
        f0 = b0 * inverse
        f1 = b1 * inverse
        f2 = b2 * inverse
        # The nodes' share is symmetric: only the lower triangle is formed.
        square[0, 0] = fma(-f0, b0, square[0, 0])
        square[1, 0] = fma(-f1, b0, square[1, 0])
        square[1, 1] = fma(-f1, b1, square[1, 1])
        square[2, 0] = fma(-f2, b0, square[2, 0])
        square[2, 1] = fma(-f2, b1, square[2, 1])
        square[2, 2] = fma(-f2, b2, square[2, 2])
        square[0, 1] = fma(-f0, b1, square[0, 1])
        square[0, 2] = fma(-f0, b2, square[0, 2])
        square[1, 2] = fma(-f1, b2, square[1, 2])
        x[0] = fma(-f0, value, x[0])
        x[1] = fma(-f1, value, x[1])
        x[2] = fma(-f2, value, x[2])
    negative = negative + solve_square(square, x)
    x0 = x[0]
    x1 = x[1]
    x2 = x[2]
    for j in range(size - 1, HALF_BANDWIDTH - 1, -1):
        value = fma(-border[j, 0], x0, nodes[j])
        value = fma(-border[j, 1], x1, value)
        value = fma(-border[j, 2], x2, value)
        substitute_back(band, nodes, j, value)
    return negative


@kernel
def solve_square(square: Any, x: Any) -> Any:
    """Solve the frame's own 3 x 3 block for x[0:3]; returns the number of pivots <= 0."""
    s00 = square[0, 0]
    inverse = 1.0 / s00
    f1 = square[1, 0] * inverse
    f2 = square[2, 0] * inverse
    s11 = square[1, 1] - f1 * square[0, 1]
    s12 = square[1, 2] - f1 * square[0, 2]
    s21 = square[2, 1] - f2 * square[0, 1]
    s22 = square[2, 2] - f2 * square[0, 2]
    x1 = x[1] - f1 * x[0]
    x2 = x[2] - f2 * x[0]
    f2 = s21 / s11
    s22 = s22 - f2 * s12
    x[2] = (x2 - f2 * x1) / s22
    x[1] = (x1 - s12 * x[2]) / s11
    x[0] = (x[0] - square[0, 1] * x[1] - square[0, 2] * x[2]) * inverse
    negative = where(s00 > 0.0, 0.0, 1.0) + where(s11 > 0.0, 0.0, 1.0)
    return negative + where(s22 > 0.0, 0.0, 1.0)
