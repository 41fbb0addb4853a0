"""Symmetric banded elimination with a border: L D L^T over the nodes, then the frame's block.

The nodes' matrix has half-bandwidth 5; the frame's three coordinates couple to the nodes only
near the clamps but fill in, so they are kept as a border of three rows. Only the frame's own
3 x 3 block may be unsymmetric (friction at its feet): it is solved last, with pivoting by size
of the diagonal being unnecessary since its inertia dominates it.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma, where

BORDER = 3


@kernel
def solve_nodes(system: Any) -> Any:
    """Solve without a border; the residual holds the nodes alone."""
    band = system.band
    x = system.residual
    size = band.shape[0] - HALF_BANDWIDTH
    negative = 0.0 * band[0, 0]
    for j in range(size):
        negative = negative + where(band[j, 0] > 0.0, 0.0, 1.0)
        inverse = 1.0 / band[j, 0]
        band[j, 0] = inverse
        for k in range(1, HALF_BANDWIDTH + 1):
            factor = band[j, k] * inverse
            for m in range(k, HALF_BANDWIDTH + 1):
                band[j + k, m - k] = fma(-factor, band[j, m], band[j + k, m - k])
            x[j + k] = fma(-factor, x[j], x[j + k])
    for j in range(size - 1, -1, -1):
        value = x[j]
        for k in range(1, HALF_BANDWIDTH + 1):
            value = fma(-band[j, k], x[j + k], value)
        x[j] = value * band[j, 0]
    return negative


@kernel
def solve_bordered(system: Any) -> Any:
    """Solve with a frame of three coordinates, which come first in the residual."""
    band = system.band
    border = system.border
    square = system.square
    x = system.residual
    beam = x[BORDER:]
    size = band.shape[0] - HALF_BANDWIDTH
    negative = 0.0 * band[0, 0]
    s00 = square[0, 0]
    s01 = square[0, 1]
    s02 = square[0, 2]
    s10 = square[1, 0]
    s11 = square[1, 1]
    s12 = square[1, 2]
    s20 = square[2, 0]
    s21 = square[2, 1]
    s22 = square[2, 2]
    x0 = x[0]
    x1 = x[1]
    x2 = x[2]
    for j in range(size):
        pivot = band[j, 0]
        negative = negative + where(pivot > 0.0, 0.0, 1.0)
        inverse = 1.0 / pivot
        band[j, 0] = inverse
        b0 = border[j, 0]
        b1 = border[j, 1]
        b2 = border[j, 2]
        value = beam[j]
        for k in range(1, HALF_BANDWIDTH + 1):
            factor = band[j, k] * inverse
            for m in range(k, HALF_BANDWIDTH + 1):
                band[j + k, m - k] = fma(-factor, band[j, m], band[j + k, m - k])
            border[j + k, 0] = fma(-factor, b0, border[j + k, 0])
            border[j + k, 1] = fma(-factor, b1, border[j + k, 1])
            border[j + k, 2] = fma(-factor, b2, border[j + k, 2])
            beam[j + k] = fma(-factor, value, beam[j + k])
        f0 = b0 * inverse
        f1 = b1 * inverse
        f2 = b2 * inverse
        s00 = fma(-f0, b0, s00)
        s01 = fma(-f0, b1, s01)
        s02 = fma(-f0, b2, s02)
        s10 = fma(-f1, b0, s10)
        s11 = fma(-f1, b1, s11)
        s12 = fma(-f1, b2, s12)
        s20 = fma(-f2, b0, s20)
        s21 = fma(-f2, b1, s21)
        s22 = fma(-f2, b2, s22)
        x0 = fma(-f0, value, x0)
        x1 = fma(-f1, value, x1)
        x2 = fma(-f2, value, x2)
    inverse = 1.0 / s00
    f1 = s10 * inverse
    f2 = s20 * inverse
    s11 = fma(-f1, s01, s11)
    s12 = fma(-f1, s02, s12)
    x1 = fma(-f1, x0, x1)
    s21 = fma(-f2, s01, s21)
    s22 = fma(-f2, s02, s22)
    x2 = fma(-f2, x0, x2)
    f2 = s21 / s11
    s22 = fma(-f2, s12, s22)
    x2 = fma(-f2, x1, x2)
    x2 = x2 / s22
    x1 = (x1 - s12 * x2) / s11
    x0 = (x0 - s01 * x1 - s02 * x2) * inverse
    x[0] = x0
    x[1] = x1
    x[2] = x2
    for j in range(size - 1, -1, -1):
        value = beam[j]
        value = fma(-border[j, 0], x0, value)
        value = fma(-border[j, 1], x1, value)
        value = fma(-border[j, 2], x2, value)
        for k in range(1, HALF_BANDWIDTH + 1):
            value = fma(-band[j, k], beam[j + k], value)
        beam[j] = value * band[j, 0]
    negative = negative + where(s00 > 0.0, 0.0, 1.0)
    negative = negative + where(s11 > 0.0, 0.0, 1.0)
    negative = negative + where(s22 > 0.0, 0.0, 1.0)
    return negative
