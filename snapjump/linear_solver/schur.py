"""Schur complement of the eliminated nodes in the frame's block, and its solution."""

from typing import Any, NamedTuple

from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma, where


class Schur(NamedTuple):
    """Terms of a Schur complement: what eliminated nodes take from the frame's block (xx, xy, yy,
    xt, yt, tt) and right-hand side (x, y, t), t standing for its direction theta."""

    xx: Any
    xy: Any
    yy: Any
    xt: Any
    yt: Any
    tt: Any
    x: Any
    y: Any
    t: Any


@kernel
def with_column(schur: Schur, column: Any, over: Any, right: Any) -> Schur:
    """The terms with those of one more eliminated column.

    column: its (x, y, t) in the border; over: one over its pivot; right: its right-hand side.
    """
    x, y, t = column
    fx = x * over
    fy = y * over
    ft = t * over
    return Schur(
        fma(fx, x, schur.xx),
        fma(fx, y, schur.xy),
        fma(fy, y, schur.yy),
        fma(fx, t, schur.xt),
        fma(fy, t, schur.yt),
        fma(ft, t, schur.tt),
        fma(fx, right, schur.x),
        fma(fy, right, schur.y),
        fma(ft, right, schur.t),
    )


@kernel
def subtract_schur(schur: Schur, block: Any, right: Any) -> None:
    """Subtract the terms from the frame's block and right-hand side."""
    block[0, 0] -= schur.xx
    block[0, 1] -= schur.xy
    block[1, 0] -= schur.xy
    block[1, 1] -= schur.yy
    block[0, 2] -= schur.xt
    block[2, 0] -= schur.xt
    block[1, 2] -= schur.yt
    block[2, 1] -= schur.yt
    block[2, 2] -= schur.tt
    right[0] -= schur.x
    right[1] -= schur.y
    right[2] -= schur.t


@kernel
def solve_block(block: Any, x: Any) -> Any:
    """Solve the frame's own 3 x 3 block for x[0:3]; returns the number of pivots <= 0."""
    s00 = block[0, 0]
    inverse = 1.0 / s00
    f1 = block[1, 0] * inverse
    f2 = block[2, 0] * inverse
    s11 = block[1, 1] - f1 * block[0, 1]
    s12 = block[1, 2] - f1 * block[0, 2]
    s21 = block[2, 1] - f2 * block[0, 1]
    s22 = block[2, 2] - f2 * block[0, 2]
    x1 = x[1] - f1 * x[0]
    x2 = x[2] - f2 * x[0]
    f2 = s21 / s11
    s22 = s22 - f2 * s12
    x[2] = (x2 - f2 * x1) / s22
    x[1] = (x1 - s12 * x[2]) / s11
    x[0] = (x[0] - block[0, 1] * x[1] - block[0, 2] * x[2]) * inverse
    negative = where(s00 > 0.0, 0.0, 1.0) + where(s11 > 0.0, 0.0, 1.0)
    return negative + where(s22 > 0.0, 0.0, 1.0)
