"""The elastic frame's linear system: a band, the beam's stiffness at both mounts, a border of four.

Eliminating the beam leaves a matrix of 6 x 6 that couples the mounts' coordinates (x, y and
direction of either). A mount is an edge of the frame, so the Jacobian of its two nodes' four
coordinates maps that matrix onto 8 x 8 of the frame's. The left mount's nodes follow each other,
so their part joins the band; the right mount's four coordinates are kept as a border that is
solved last.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.frame.parts.elastic_mesh import LEFT_MOUNT, mount_at, node_count, right_mount
from snapjump.linear_solver.banded import (
    eliminate_x_column,
    eliminate_y_column,
    reduce_x_entry,
    reduce_y_entry,
)
from snapjump.linear_solver.schur import subtract_schur
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import fma, where

BORDER = 4
REACH = 4  # columns before the last node, which the right mount's border starts with


@kernel
def fill_mount_jacobian(mesh: Any, state: Any, jacobian: Any) -> None:
    """Derivatives of the mounts' (x, y, direction) by the coordinates of their nodes, (8, 3)."""
    for side in range(2):
        edge = mesh[LEFT_MOUNT] if side == 0 else right_mount(mesh)
        mount = mount_at(edge, 1.0, state)
        zero = 0.0 * mount.x
        for node in range(2):
            row = 4 * side + 2 * node
            sign = 1.0 if node == 1 else -1.0
            jacobian[row, 0] = zero + 0.5
            jacobian[row, 1] = zero
            jacobian[row, 2] = sign * mount.slope_x
            jacobian[row + 1, 0] = zero
            jacobian[row + 1, 1] = zero + 0.5
            jacobian[row + 1, 2] = sign * mount.slope_y


@kernel
def take_beam(work: Any, done: Any) -> None:
    """Subtract from the mounts' matrix and right-hand side what the eliminated nodes take.

    The left mount's part was summed up on the way; the right mount's border begins with the last
    columns, whose factors are still in the band.
    """
    square = work.corner_block
    mounts = work.mount_residual
    subtract_schur(done.schur, square, mounts)
    band = work.padded_band
    border = work.padded_border
    end = band.shape[0] - HALF_BANDWIDTH - 2
    for j in range(end - REACH, end):
        over = band[j, 0]
        for k in range(3, 6):
            value = border[j, k]
            for back in range(1, j - (end - REACH) + 1):
                value = fma(-band[j - back, back] * band[j - back, 0], border[j - back, k], value)
            border[j, k] = value
        for k in range(3, 6):
            factor = border[j, k] * over
            mounts[k] = fma(-factor, work.padded_residual[j], mounts[k])
            for m in range(6):
                square[k, m] = fma(-factor, border[j, m], square[k, m])


@kernel
def between(work: Any, row: Any, column: Any) -> Any:
    """Entry of the mounts' matrix between two of the eight coordinates of their nodes."""
    jacobian = work.mount_jacobian
    k = 3 * (row // 4)
    m = 3 * (column // 4)
    total = 0.0 * jacobian[row, 0]
    for a in range(3):
        inner = work.corner_block[k + a, m] * jacobian[column, 0]
        inner = fma(work.corner_block[k + a, m + 1], jacobian[column, 1], inner)
        inner = fma(work.corner_block[k + a, m + 2], jacobian[column, 2], inner)
        total = fma(jacobian[row, a], inner, total)
    return total


@kernel
def detach_right(first: Any, work: Any) -> None:
    """Move four coordinates, from ``first`` on, out of the frame's band into its border."""
    band = work.padded_frame_band
    border = work.padded_frame_border
    rhs = work.padded_frame_residual
    zero = 0.0 * rhs[first]
    for j in range(first - HALF_BANDWIDTH, first):
        for r in range(BORDER):
            k = first + r - j
            if k <= HALF_BANDWIDTH:
                border[j, r] = band[j, k]
                band[j, k] = zero
    for r in range(BORDER):
        j = first + r
        for k in range(HALF_BANDWIDTH + 1):
            if r + k < BORDER:
                work.last_block[r, r + k] = band[j, k]
                work.last_block[r + k, r] = band[j, k]
            else:
                border[j + k, r] = band[j, k]
            band[j, k] = zero
        band[j, 0] = zero + 1.0
        work.last_residual[r] = rhs[j]
        rhs[j] = zero


@kernel
def add_mounts(left: Any, work: Any) -> None:
    """Add the mounts' matrix and right-hand side to band, border and last block."""
    rhs = work.padded_frame_residual
    for c in range(4):
        for r in range(c, 4):
            work.padded_frame_band[left + c, r - c] += between(work, r, c)
        for r in range(4):
            work.padded_frame_border[left + c, r] += between(work, r + 4, c)
            work.last_block[r, c] += between(work, r + 4, c + 4)
        for a in range(3):
            rhs[left + c] += work.mount_jacobian[c, a] * work.mount_residual[a]
            work.last_residual[c] += work.mount_jacobian[c + 4, a] * work.mount_residual[a + 3]


@kernel
def reduce_border(border: Any, j: Any, factors: Any) -> None:
    """Bring column j of the border up to date, given its factors with the columns before it."""
    f1, f2, f3, f4, f5 = factors
    for r in range(BORDER):
        value = fma(-f4, border[j - 4, r], fma(-f5, border[j - 5, r], border[j, r]))
        value = fma(-f2, border[j - 2, r], fma(-f3, border[j - 3, r], value))
        border[j, r] = fma(-f1, border[j - 1, r], value)


@kernel
def take_column(j: Any, work: Any) -> None:
    """Subtract from the last block what an eliminated column takes."""
    border = work.padded_frame_border
    over = work.padded_frame_band[j, 0]
    value = work.padded_frame_residual[j]
    for r in range(BORDER):
        factor = border[j, r] * over
        work.last_residual[r] = fma(-factor, value, work.last_residual[r])
        for c in range(r + 1):
            work.last_block[r, c] = fma(-factor, border[j, c], work.last_block[r, c])


@routine
def eliminate_chain(left: Any, work: Any) -> Any:
    """Eliminate all of the frame's columns; returns the number of pivots <= 0."""
    band = work.padded_frame_band
    rhs = work.padded_frame_residual
    negative = 0.0 * rhs[0]
    for i in range(HALF_BANDWIDTH, band.shape[0] - HALF_BANDWIDTH, 2):
        j = i + 1
        f1, f2, f3, f4 = eliminate_x_column(band, i, band[i])
        of_y = eliminate_y_column(band, j, band[j])
        reduce_x_entry(rhs, i, rhs[i], (f1, f2, f3, f4))
        reduce_y_entry(rhs, j, rhs[j], of_y)
        negative = negative + where(band[i, 0] > 0.0, 0.0, 1.0) + where(band[j, 0] > 0.0, 0.0, 1.0)
        if i >= left:
            reduce_border(work.padded_frame_border, i, (f1, f2, f3, f4, 0.0 * f1))
            reduce_border(work.padded_frame_border, j, of_y)
            take_column(i, work)
            take_column(j, work)
    return negative


@kernel
def solve_last(square: Any, x: Any) -> Any:
    """Solve the symmetric last block (its lower triangle); returns the number of pivots <= 0."""
    negative = 0.0 * x[0]
    for j in range(BORDER):
        pivot = square[j, j]
        negative = negative + where(pivot > 0.0, 0.0, 1.0)
        for r in range(j + 1, BORDER):
            factor = square[r, j] / pivot
            x[r] = fma(-factor, x[j], x[r])
            for c in range(j + 1, r + 1):
                square[r, c] = fma(-factor, square[c, j], square[r, c])
    for j in range(BORDER - 1, -1, -1):
        value = x[j]
        for r in range(j + 1, BORDER):
            value = fma(-square[r, j], x[r], value)
        x[j] = value / square[j, j]
    return negative


@routine
def substitute_chain(left: Any, first: Any, work: Any) -> None:
    """Replace the frame's right-hand side by the solution."""
    band = work.padded_frame_band
    border = work.padded_frame_border
    rhs = work.padded_frame_residual
    last = work.last_residual
    for j in range(band.shape[0] - HALF_BANDWIDTH - 1, HALF_BANDWIDTH - 1, -1):
        value = rhs[j]
        if j >= left:
            for r in range(BORDER):
                value = fma(-border[j, r], last[r], value)
        value = fma(-band[j, 4], rhs[j + 4], fma(-band[j, 5], rhs[j + 5], value))
        value = fma(-band[j, 2], rhs[j + 2], fma(-band[j, 3], rhs[j + 3], value))
        rhs[j] = fma(-band[j, 1], rhs[j + 1], value) * band[j, 0]
    for r in range(BORDER):
        rhs[first + r] = last[r]


@routine
def solve_chain(work: Any, done: Any) -> Any:
    """Solve for the frame's coordinates; returns the number of pivots <= 0."""
    mesh = work.mesh
    left = 2 * mesh[LEFT_MOUNT] + HALF_BANDWIDTH
    first = 2 * right_mount(mesh) + HALF_BANDWIDTH
    zero = 0.0 * done.negative
    for j in range(left, 2 * node_count(mesh) + HALF_BANDWIDTH):
        for r in range(BORDER):
            work.padded_frame_border[j, r] = zero
    fill_mount_jacobian(mesh, work.state, work.mount_jacobian)
    take_beam(work, done)
    detach_right(first, work)
    add_mounts(left, work)
    negative = eliminate_chain(left, work)
    negative = negative + solve_last(work.last_block, work.last_residual)
    substitute_chain(left, first, work)

    rhs = work.padded_frame_residual
    mounts = work.mount_residual
    for a in range(3):
        mounts[a] = zero
        mounts[a + 3] = zero
        for c in range(4):
            mounts[a] = fma(work.mount_jacobian[c, a], rhs[left + c], mounts[a])
            mounts[a + 3] = fma(work.mount_jacobian[c + 4, a], rhs[first + c], mounts[a + 3])
    values = work.padded_residual
    border = work.padded_border
    end = values.shape[0] - HALF_BANDWIDTH - 2
    for j in range(HALF_BANDWIDTH, end):
        value = fma(-border[j, 0], mounts[0], values[j])
        value = fma(-border[j, 1], mounts[1], value)
        values[j] = fma(-border[j, 2], mounts[2], value)
        if j >= end - REACH:
            for k in range(3, 6):
                values[j] = fma(-border[j, k], mounts[k], values[j])
    return negative
