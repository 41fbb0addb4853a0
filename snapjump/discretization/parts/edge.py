"""Edges between nodes and the angles between them, and their derivatives in closed form.

In duals, the same formulas would carry derivatives through every root and quotient. An edge's
derivatives need no more than its change of length and of direction.
"""

from typing import Any, NamedTuple

from numba.extending import overload

from snapjump.number.dispatch import INLINED, kernel
from snapjump.number.dual import dual, plus, slopes_of, times, times_plus, value_of
from snapjump.number.dual_type import DualType
from snapjump.number.functions import fma, sqrt


class Edge(NamedTuple):
    """An edge vector's length and its inverse, unit tangent, gradient of its direction (rad/L),
    the rate of its direction (rad/T) and of its length (L/T)."""

    length: Any
    over: Any
    cx: Any
    cy: Any
    slope_x: Any
    slope_y: Any
    turn_rate: Any
    stretch_rate: Any


@kernel
def edge_of(ex: Any, ey: Any, vx: Any, vy: Any) -> Edge:
    """:func:`make_edge` of plain numbers."""
    length = sqrt(fma(ex, ex, ey * ey))
    over = 1.0 / length
    cx = ex * over
    cy = ey * over
    turn_rate = (cx * vy - cy * vx) * over
    return Edge(length, over, cx, cy, -cy * over, cx * over, turn_rate, cx * vx + cy * vy)


@kernel
def combined(a: Any, x: Any, b: Any, y: Any) -> Any:
    """a x + b y of slopes x and y."""
    return times_plus(x, a, times(y, b))


@kernel
def edge_of_duals(ex: Any, ey: Any, vx: Any, vy: Any) -> Edge:
    """:func:`make_edge` of duals."""
    edge = edge_of(value_of(ex), value_of(ey), value_of(vx), value_of(vy))
    cx = edge.cx
    cy = edge.cy
    over = edge.over
    along = combined(cx, slopes_of(ex), cy, slopes_of(ey))  # of the length
    turn = combined(edge.slope_x, slopes_of(ex), edge.slope_y, slopes_of(ey))  # of the direction
    swept = combined(-edge.stretch_rate, turn, -edge.turn_rate, along)
    swing = plus(combined(cx, slopes_of(vy), -cy, slopes_of(vx)), swept)
    apart = combined(cx, slopes_of(vx), cy, slopes_of(vy))
    x = dual(cx, times(turn, -cy))
    y = dual(cy, times(turn, cx))
    inverse = dual(over, times(along, -(over * over)))
    return Edge(
        dual(edge.length, along),
        inverse,
        x,
        y,
        -y * inverse,
        x * inverse,
        dual(edge.turn_rate, times(swing, over)),
        dual(edge.stretch_rate, times_plus(turn, edge.turn_rate * edge.length, apart)),
    )


def all_duals(*kinds: Any) -> bool:
    """Whether the numba types are those of duals."""
    return all(isinstance(kind, DualType) for kind in kinds)


def make_edge(ex: Any, ey: Any, vx: Any, vy: Any) -> Edge:
    """The edge (ex, ey) whose ends move apart with (vx, vy)."""
    return edge_of(ex, ey, vx, vy)


@overload(make_edge, strict=False, jit_options=INLINED)
def _make_edge(ex: Any, ey: Any, vx: Any, vy: Any) -> Any:
    return edge_of_duals if all_duals(ex, ey, vx, vy) else edge_of


@kernel
def tangent_between(ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    """:func:`half_angle_tangent` of plain numbers."""
    return (ax * by - ay * bx) / (1.0 + ax * bx + ay * by)


@kernel
def turn_of(x: Any, y: Any) -> Any:
    """Derivatives of the direction of a unit vector that stays one."""
    return combined(value_of(x), slopes_of(y), -value_of(y), slopes_of(x))


@kernel
def tangent_between_duals(ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    """:func:`half_angle_tangent` of duals."""
    t = tangent_between(value_of(ax), value_of(ay), value_of(bx), value_of(by))
    turned = times_plus(turn_of(ax, ay), -1.0 + 0.0 * t, turn_of(bx, by))
    return dual(t, times(turned, fma(0.5 * t, t, 0.5)))


def half_angle_tangent(ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    """tan(phi/2) of the turning angle between two unit vectors."""
    return tangent_between(ax, ay, bx, by)


@overload(half_angle_tangent, strict=False, jit_options=INLINED)
def _half_angle_tangent(ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    return tangent_between_duals if all_duals(ax, ay, bx, by) else tangent_between
