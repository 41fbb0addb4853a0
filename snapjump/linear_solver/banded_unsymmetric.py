"""Unsymmetric banded elimination with a border, L U over the nodes, for four right-hand sides.

The matrix is that of :mod:`snapjump.linear_solver.banded` with what that leaves out: friction by
the gap of a node, and rates of strain that depend on where nodes are. Right-hand sides are slopes
of duals, all lanes of one parameter after the other.

Of an eliminated row and column j, ``padded_factors[j]`` has one over the pivot, L below it, U to
the right of it, the frame's columns of U and its rows of L.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH, RIGHT
from snapjump.linear_solver.contact_rows import NodeRows
from snapjump.number.dispatch import kernel, routine
from snapjump.number.dual import each
from snapjump.number.functions import fma

MOUNT = 3  # coordinates of the frame
COLUMNS = RIGHT + HALF_BANDWIDTH  # where the frame's begin
ROWS = COLUMNS + MOUNT
FACTORS = ROWS + MOUNT


@kernel
def reduced(value: Any, work: Any, j: Any, reach: Any, of: Any, by: Any, shift: Any) -> Any:
    """``value`` less products of two entries of the rows k before j, k from ``reach`` down: those
    at ``of`` + k and at ``by`` + ``shift`` k."""
    factors = work.padded_factors
    # The row just before comes last: its pivot is the one still being computed.
    for k in range(reach, 0, -1):
        value = fma(-factors[j - k, of + k], factors[j - k, by + shift * k], value)
    return value


@kernel
def eliminate_row(work: Any, j: Any, axis: Any, own: NodeRows, coupled: Any, reach: Any) -> None:
    """Eliminate a row and a column; ``reach``: how far before it they begin. They end with the last
    coordinate of a node, and what lies beyond is zero, here and in the factors."""
    factors = work.padded_factors
    right = HALF_BANDWIDTH
    pivot = reduced(own.band[axis, 0] + own.skew[axis, 0], work, j, reach, 0, right, 1)
    over = 1.0 / pivot
    factors[j, 0] = over
    for m in range(1, RIGHT - axis):
        entry = own.band[axis, m]
        below = entry + own.skew[axis, m]
        beside = entry + own.skew[axis, right + m]
        reaching = min(reach, HALF_BANDWIDTH - m)
        factors[j, m] = reduced(below, work, j, reaching, right, m, 1) * over
        factors[j, right + m] = reduced(beside, work, j, reaching, 0, right + m, 1)
    for a in range(MOUNT):
        column = 0.0 * pivot
        row = 0.0 * pivot
        if coupled:
            entry = work.padded_border[j, a]
            column = entry + work.padded_border_skew[j, a]
            row = entry + work.padded_border_skew[j, MOUNT + a]
        factors[j, COLUMNS + a] = reduced(column, work, j, reach, 0, COLUMNS + a, 0)
        factors[j, ROWS + a] = reduced(row, work, j, reach, right, ROWS + a, 0) * over


@kernel
def take_from_frame(work: Any, j: Any, count: Any) -> None:
    """Take from the frame's block what ``count`` rows and columns from j on leave there."""
    factors = work.padded_factors
    block = work.corner_block
    for a in range(MOUNT):
        for b in range(MOUNT):
            value = block[a, b]
            for i in range(j, j + count):
                value = fma(-factors[i, ROWS + a], factors[i, COLUMNS + b], value)
            block[a, b] = value


@kernel
def eliminate_unsymmetric(work: Any, node: Any, dofs: Any, own: NodeRows, coupled: Any) -> None:
    """Eliminate a node whose own rows are complete, and its border, where it is ``coupled``."""
    j = dofs * node + HALF_BANDWIDTH
    if dofs == 3:
        eliminate_row(work, j, 0, own, coupled, 5)
        eliminate_row(work, j + 1, 1, own, coupled, 5)
        eliminate_row(work, j + 2, 2, own, coupled, 5)
    else:
        eliminate_row(work, j, 0, own, coupled, 4)
        eliminate_row(work, j + 1, 1, own, coupled, 5)
    take_from_frame(work, j, dofs)


@kernel
def eliminate_frame(work: Any) -> None:
    """Eliminate the frame's own 3 x 3 block, once all nodes are."""
    block = work.corner_block
    for j in range(MOUNT):
        over = 1.0 / block[j, j]
        block[j, j] = over
        for a in range(j + 1, MOUNT):
            factor = block[a, j] * over
            block[a, j] = factor
            for b in range(j + 1, MOUNT):
                block[a, b] = fma(-factor, block[j, b], block[a, b])


@routine
def solve_sides(work: Any, sides: Any, frame: Any) -> None:
    """Replace right-hand sides (slopes), of the nodes with their padding and of the frame, by the
    solutions."""
    factors = work.padded_factors
    block = work.corner_block
    end = sides.shape[0] - HALF_BANDWIDTH
    for j in range(HALF_BANDWIDTH, end):
        value = sides[j]
        for k in range(HALF_BANDWIDTH, 0, -1):
            value = fma(each(-factors[j - k, k]), sides[j - k], value)
        sides[j] = value
        for a in range(MOUNT):
            frame[a] = fma(each(-factors[j, ROWS + a]), value, frame[a])
    for j in range(MOUNT):
        for a in range(j + 1, MOUNT):
            frame[a] = fma(each(-block[a, j]), frame[j], frame[a])
    for j in range(MOUNT - 1, -1, -1):
        value = frame[j]
        for b in range(j + 1, MOUNT):
            value = fma(each(-block[j, b]), frame[b], value)
        frame[j] = each(block[j, j]) * value
    for j in range(end - 1, HALF_BANDWIDTH - 1, -1):
        value = sides[j]
        for a in range(MOUNT):
            value = fma(each(-factors[j, COLUMNS + a]), frame[a], value)
        for k in range(HALF_BANDWIDTH, 0, -1):
            value = fma(each(-factors[j, HALF_BANDWIDTH + k]), sides[j + k], value)
        sides[j] = each(factors[j, 0]) * value
