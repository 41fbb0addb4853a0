"""The elimination of :mod:`snapjump.linear_solver.banded` for nodes of three coordinates.

A node couples to the next one only: the column of its x reaches five rows down, that of its y
four, that of its rotation three.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.linear_solver.banded import Elimination
from snapjump.linear_solver.schur import with_column
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, fma, maximum, where


@kernel
def eliminate_first_column(band: Any, j: Any) -> Any:
    """Bring column j, of a node's x, up to date; returns the factors of the three columns before
    it, nearest first."""
    # The column just before comes last everywhere: its pivot is the one still being computed.
    f1 = band[j - 1, 1] * band[j - 1, 0]
    f2 = band[j - 2, 2] * band[j - 2, 0]
    f3 = band[j - 3, 3] * band[j - 3, 0]
    pivot = fma(-f2, band[j - 2, 2], fma(-f3, band[j - 3, 3], band[j, 0]))
    next_y = fma(-f2, band[j - 2, 3], fma(-f3, band[j - 3, 4], band[j, 1]))
    next_turn = fma(-f2, band[j - 2, 4], fma(-f3, band[j - 3, 5], band[j, 2]))
    band[j, 0] = 1.0 / fma(-f1, band[j - 1, 1], pivot)
    band[j, 1] = fma(-f1, band[j - 1, 2], next_y)
    band[j, 2] = fma(-f1, band[j - 1, 3], next_turn)
    return f1, f2, f3


@kernel
def eliminate_second_column(band: Any, j: Any) -> Any:
    """The same for a node's y and the four columns before it."""
    f1 = band[j - 1, 1] * band[j - 1, 0]
    f2 = band[j - 2, 2] * band[j - 2, 0]
    f3 = band[j - 3, 3] * band[j - 3, 0]
    f4 = band[j - 4, 4] * band[j - 4, 0]
    pivot = fma(-f3, band[j - 3, 3], fma(-f4, band[j - 4, 4], band[j, 0]))
    pivot = fma(-f2, band[j - 2, 2], pivot)
    below = fma(-f3, band[j - 3, 4], fma(-f4, band[j - 4, 5], band[j, 1]))
    below = fma(-f2, band[j - 2, 3], below)
    band[j, 0] = 1.0 / fma(-f1, band[j - 1, 1], pivot)
    band[j, 1] = fma(-f1, band[j - 1, 2], below)
    for k in range(2, 5):
        band[j, k] = fma(-f1, band[j - 1, k + 1], band[j, k])
    return f1, f2, f3, f4


@kernel
def eliminate_third_column(band: Any, j: Any) -> Any:
    """The same for a node's rotation and the five columns before it."""
    f1 = band[j - 1, 1] * band[j - 1, 0]
    f2 = band[j - 2, 2] * band[j - 2, 0]
    f3 = band[j - 3, 3] * band[j - 3, 0]
    f4 = band[j - 4, 4] * band[j - 4, 0]
    f5 = band[j - 5, 5] * band[j - 5, 0]
    pivot = fma(-f4, band[j - 4, 4], fma(-f5, band[j - 5, 5], band[j, 0]))
    pivot = fma(-f2, band[j - 2, 2], fma(-f3, band[j - 3, 3], pivot))
    band[j, 0] = 1.0 / fma(-f1, band[j - 1, 1], pivot)
    for k in range(1, 4):
        band[j, k] = fma(-f1, band[j - 1, k + 1], fma(-f2, band[j - 2, k + 2], band[j, k]))
    return f1, f2, f3, f4, f5


@kernel
def reduced(values: Any, j: Any, factors: Any) -> Any:
    """Entry j of a right-hand side brought up to date with the first three columns before it."""
    value = fma(-factors[2], values[j - 3], values[j])
    return fma(-factors[0], values[j - 1], fma(-factors[1], values[j - 2], value))


@kernel
def reduce_entries(values: Any, i: Any, first: Any, second: Any, third: Any) -> None:
    """Bring a node's three entries of a right-hand side, from i on, up to date."""
    values[i] = reduced(values, i, first)
    values[i + 1] = fma(-second[3], values[i - 3], values[i + 1])
    values[i + 1] = reduced(values, i + 1, second)
    values[i + 2] = fma(-third[4], values[i - 3], values[i + 2])
    values[i + 2] = fma(-third[3], values[i - 2], values[i + 2])
    values[i + 2] = reduced(values, i + 2, third)


@kernel
def eliminate_rotating_node(work: Any, node: Any, bordered: Any, done: Elimination) -> Elimination:
    """Eliminate a node whose columns, and whose share of the border, are complete."""
    band = work.padded_band
    rhs = work.padded_residual
    border = work.padded_border
    i = 3 * node + HALF_BANDWIDTH
    largest = maximum(maximum(done.largest, absolute(rhs[i])), absolute(rhs[i + 1]))
    largest = maximum(largest, absolute(rhs[i + 2]))
    first = eliminate_first_column(band, i)
    second = eliminate_second_column(band, i + 1)
    third = eliminate_third_column(band, i + 2)
    reduce_entries(rhs, i, first, second, third)
    negative = done.negative
    for k in range(3):
        negative = negative + where(band[i + k, 0] > 0.0, 0.0, 1.0)
    schur = done.schur
    if bordered:
        for k in range(3):
            reduce_entries(border[:, k], i, first, second, third)
        for j in range(i, i + 3):
            column = (border[j, 0], border[j, 1], border[j, 2])
            schur = with_column(schur, column, band[j, 0], rhs[j])
    return Elimination(negative, largest, schur)


@kernel
def substitute_back_rotating(work: Any, bordered: Any, zero: Any) -> Any:
    """Replace the nodes' right-hand side by the solution; returns its largest entry."""
    band = work.padded_band
    border = work.padded_border
    rhs = work.padded_residual
    frame = work.frame_residual
    next_x = zero  # of the next node
    next_y = zero
    next_t = zero
    largest = zero
    for j in range(rhs.shape[0] - HALF_BANDWIDTH - 3, HALF_BANDWIDTH - 1, -3):
        x = rhs[j]
        y = rhs[j + 1]
        t = rhs[j + 2]
        if bordered:
            for k in range(3):
                x = fma(-border[j, k], frame[k], x)
                y = fma(-border[j + 1, k], frame[k], y)
                t = fma(-border[j + 2, k], frame[k], t)
        t = fma(-band[j + 2, 3], next_t, t)
        t = fma(-band[j + 2, 2], next_y, t)
        t = fma(-band[j + 2, 1], next_x, t) * band[j + 2, 0]
        y = fma(-band[j + 1, 4], next_t, y)
        y = fma(-band[j + 1, 3], next_y, y)
        y = fma(-band[j + 1, 2], next_x, y)
        y = fma(-band[j + 1, 1], t, y) * band[j + 1, 0]
        x = fma(-band[j, 5], next_t, x)
        x = fma(-band[j, 4], next_y, x)
        x = fma(-band[j, 3], next_x, x)
        x = fma(-band[j, 2], t, x)
        x = fma(-band[j, 1], y, x) * band[j, 0]
        rhs[j] = x
        rhs[j + 1] = y
        rhs[j + 2] = t
        largest = maximum(maximum(largest, absolute(x)), maximum(absolute(y), absolute(t)))
        next_x = x
        next_y = y
        next_t = t
    return largest
