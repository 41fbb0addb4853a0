"""Symmetric banded elimination with a border: L D L^T over the nodes, then the frame's block.

The nodes' matrix has half-bandwidth 5; the frame's three coordinates couple to the nodes only
near the clamps but fill in, so they are kept as a border of three rows. Only the frame's own
3 x 3 block may be unsymmetric (friction at its feet): it is solved last, with pivoting by size
of the diagonal being unnecessary since its inertia dominates it.

Nodes are eliminated one by one, so that the columns of a node can be formed just before and are
still at hand (a whole matrix of many lanes is larger than the fastest memory). A node couples to
the next two: the column of its x reaches five rows down, that of its y four. In ``band[j]`` of an
eliminated column, entry 0 is one over the pivot, the others are those of L D.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.linear_solver.contact_rows import NodeRows, rows_of
from snapjump.linear_solver.schur import Schur, solve_block, subtract_schur, with_column
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, fma, maximum, where


class Elimination(NamedTuple):
    """Running figures of an elimination: pivots of the nodes that are not positive, the largest
    residual so far, and the terms of the Schur complement."""

    negative: Any
    largest: Any
    schur: Schur


@kernel
def begin_elimination(zero: Any) -> Elimination:
    """No node eliminated yet."""
    nothing = Schur(zero, zero, zero, zero, zero, zero, zero, zero, zero)
    return Elimination(zero, zero, nothing)


@kernel
def eliminate_x_column(band: Any, j: Any, own: Any) -> Any:
    """Bring column j, of a node's x and so far in ``own``, up to date in the band; returns the
    factors of the four columns before it, nearest first."""
    # The column just before comes last everywhere: its pivot is the one still being computed.
    f1 = band[j - 1, 1] * band[j - 1, 0]
    f2 = band[j - 2, 2] * band[j - 2, 0]
    f3 = band[j - 3, 3] * band[j - 3, 0]
    f4 = band[j - 4, 4] * band[j - 4, 0]
    pivot = fma(-f4, band[j - 4, 4], own[0])
    pivot = fma(-f3, band[j - 3, 3], pivot)
    pivot = fma(-f2, band[j - 2, 2], pivot)
    pivot = fma(-f1, band[j - 1, 1], pivot)
    below = fma(-f4, band[j - 4, 5], own[1])
    below = fma(-f3, band[j - 3, 4], below)
    below = fma(-f2, band[j - 2, 3], below)
    band[j, 0] = 1.0 / pivot
    band[j, 1] = fma(-f1, band[j - 1, 2], below)
    band[j, 2] = fma(-f1, band[j - 1, 3], fma(-f2, band[j - 2, 4], own[2]))
    band[j, 3] = fma(-f1, band[j - 1, 4], fma(-f2, band[j - 2, 5], own[3]))
    band[j, 4] = own[4]
    band[j, 5] = own[5]
    return f1, f2, f3, f4


@kernel
def eliminate_y_column(band: Any, j: Any, own: Any) -> Any:
    """The same for a column of a node's y; returns the factors of the five columns before it."""
    f1 = band[j - 1, 1] * band[j - 1, 0]
    f2 = band[j - 2, 2] * band[j - 2, 0]
    f3 = band[j - 3, 3] * band[j - 3, 0]
    f4 = band[j - 4, 4] * band[j - 4, 0]
    f5 = band[j - 5, 5] * band[j - 5, 0]
    pivot = fma(-f5, band[j - 5, 5], own[0])
    pivot = fma(-f4, band[j - 4, 4], pivot)
    pivot = fma(-f3, band[j - 3, 3], pivot)
    pivot = fma(-f2, band[j - 2, 2], pivot)
    pivot = fma(-f1, band[j - 1, 1], pivot)
    next_x = fma(-f2, band[j - 2, 3], fma(-f3, band[j - 3, 4], own[1]))
    next_y = fma(-f2, band[j - 2, 4], fma(-f3, band[j - 3, 5], own[2]))
    band[j, 0] = 1.0 / pivot
    band[j, 1] = fma(-f1, band[j - 1, 2], next_x)
    band[j, 2] = fma(-f1, band[j - 1, 3], next_y)
    band[j, 3] = fma(-f1, band[j - 1, 4], own[3])
    band[j, 4] = fma(-f1, band[j - 1, 5], own[4])
    return f1, f2, f3, f4, f5


@kernel
def reduce_x_entry(values: Any, j: Any, own: Any, factors: Any) -> Any:
    """Bring entry j of a right-hand side, so far ``own``, up to date with its column and return
    it."""
    f1, f2, f3, f4 = factors
    value = fma(-f4, values[j - 4], own)
    value = fma(-f3, values[j - 3], value)
    value = fma(-f2, values[j - 2], value)
    value = fma(-f1, values[j - 1], value)
    values[j] = value
    return value


@kernel
def reduce_y_entry(values: Any, j: Any, own: Any, factors: Any) -> Any:
    """The same for a column of a node's y."""
    f1, f2, f3, f4, f5 = factors
    value = fma(-f5, values[j - 5], own)
    value = fma(-f4, values[j - 4], value)
    value = fma(-f3, values[j - 3], value)
    value = fma(-f2, values[j - 2], value)
    value = fma(-f1, values[j - 1], value)
    values[j] = value
    return value


@kernel
def reduce_x_border(border: Any, j: Any, own: Any, factors: Any) -> Any:
    """Bring column j of the border's three rows, so far ``own``, up to date and return it."""
    f1, f2, f3, f4 = factors
    b0 = fma(-f3, border[j - 3, 0], fma(-f4, border[j - 4, 0], own[0]))
    b1 = fma(-f3, border[j - 3, 1], fma(-f4, border[j - 4, 1], own[1]))
    b2 = fma(-f3, border[j - 3, 2], fma(-f4, border[j - 4, 2], own[2]))
    b0 = fma(-f1, border[j - 1, 0], fma(-f2, border[j - 2, 0], b0))
    b1 = fma(-f1, border[j - 1, 1], fma(-f2, border[j - 2, 1], b1))
    b2 = fma(-f1, border[j - 1, 2], fma(-f2, border[j - 2, 2], b2))
    border[j, 0] = b0
    border[j, 1] = b1
    border[j, 2] = b2
    return b0, b1, b2


@kernel
def reduce_y_border(border: Any, j: Any, own: Any, factors: Any) -> Any:
    """The same for a column of a node's y."""
    f1, f2, f3, f4, f5 = factors
    b0 = fma(-f5, border[j - 5, 0], own[0])
    b1 = fma(-f5, border[j - 5, 1], own[1])
    b2 = fma(-f5, border[j - 5, 2], own[2])
    return reduce_x_border(border, j, (b0, b1, b2), (f1, f2, f3, f4))


@kernel
def eliminate_columns(
    work: Any, node: Any, own: NodeRows, border: Any, bordered: Any, done: Elimination
) -> Elimination:
    """Eliminate a node whose own rows, and its columns of the border as two tuples of three, are
    complete."""
    i = 2 * node + HALF_BANDWIDTH
    j = i + 1
    x, y = own.residual[0], own.residual[1]
    largest = maximum(maximum(done.largest, absolute(x)), absolute(y))
    of_x = eliminate_x_column(work.padded_band, i, own.band[0])
    of_y = eliminate_y_column(work.padded_band, j, own.band[1])
    ri = reduce_x_entry(work.padded_residual, i, x, of_x)
    rj = reduce_y_entry(work.padded_residual, j, y, of_y)
    over_i = work.padded_band[i, 0]
    over_j = work.padded_band[j, 0]
    negative = done.negative + where(over_i > 0.0, 0.0, 1.0) + where(over_j > 0.0, 0.0, 1.0)
    schur = done.schur
    if bordered:
        rows = work.padded_border
        schur = with_column(schur, reduce_x_border(rows, i, border[0], of_x), over_i, ri)
        schur = with_column(schur, reduce_y_border(rows, j, border[1], of_y), over_j, rj)
    return Elimination(negative, largest, schur)


@kernel
def border_column(border: Any, j: Any) -> Any:
    """Column j of the border's three rows."""
    return border[j, 0], border[j, 1], border[j, 2]


@kernel
def eliminate_node(work: Any, node: Any, bordered: Any, done: Elimination) -> Elimination:
    """:func:`eliminate_columns` of a node whose rows and columns stand in memory."""
    row = 2 * node
    border = (border_column(work.border, row), border_column(work.border, row + 1))
    return eliminate_columns(work, node, rows_of(work, row), border, bordered, done)


@kernel
def solve_frame(work: Any, done: Elimination) -> Any:
    """Solve for the frame once all nodes are eliminated; returns the number of pivots <= 0."""
    subtract_schur(done.schur, work.corner_block, work.frame_residual)
    return solve_block(work.corner_block, work.frame_residual)


@kernel
def substitute_back(work: Any, bordered: Any, zero: Any) -> Any:
    """Replace the nodes' right-hand side by the solution; returns its largest entry."""
    band = work.padded_band
    border = work.padded_border
    rhs = work.padded_residual
    frame = work.frame_residual
    x0 = frame[0]
    x1 = frame[1]
    x2 = frame[2]
    next_x = zero  # of the next node
    next_y = zero
    far_x = zero  # of the next but one
    far_y = zero
    largest = zero
    for j in range(rhs.shape[0] - HALF_BANDWIDTH - 1, HALF_BANDWIDTH, -2):
        i = j - 1
        y = rhs[j]
        x = rhs[i]
        if bordered:
            y = fma(-border[j, 0], x0, y)
            y = fma(-border[j, 1], x1, y)
            y = fma(-border[j, 2], x2, y)
            x = fma(-border[i, 0], x0, x)
            x = fma(-border[i, 1], x1, x)
            x = fma(-border[i, 2], x2, x)
        y = fma(-band[j, 4], far_y, y)
        y = fma(-band[j, 3], far_x, y)
        y = fma(-band[j, 2], next_y, y)
        y = fma(-band[j, 1], next_x, y) * band[j, 0]
        x = fma(-band[i, 5], far_y, x)
        x = fma(-band[i, 4], far_x, x)
        x = fma(-band[i, 3], next_y, x)
        x = fma(-band[i, 2], next_x, x)
        x = fma(-band[i, 1], y, x) * band[i, 0]
        rhs[j] = y
        rhs[i] = x
        largest = maximum(maximum(largest, absolute(x)), absolute(y))
        far_x = next_x
        far_y = next_y
        next_x = x
        next_y = y
    return largest
