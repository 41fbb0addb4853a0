"""How far a beam turns at its nodes: what its bending strain is told by.

Curvatures are of second order in the element's length: of discrete rods those of their hinges, the
clamps' included, whose moments are in balance with the others; of elements with rotations those in
the elements' middles, carried to the nodes.
"""

from typing import Any

from snapjump.discretization.parts.edge import half_angle_tangent, make_edge
from snapjump.number.dispatch import kernel
from snapjump.number.functions import where


@kernel
def fill_turnings(discretization: Any, position: Any, tangents: Any, turnings: Any) -> None:
    """Fill the turning (N + 1) over an element's length, which is the curvature times that, at the
    nodes of a chain with coordinates ``position`` (D) between clamps of these directions."""
    if discretization.node_dofs() == 3:
        fill_from_rotations(discretization.rotation_length(), position, turnings)
    else:
        fill_from_edges(position, tangents, turnings)
        # At a clamp half an element turns.
        factor = where(discretization.clamp_distance() == 0.0, 2.0, 1.0)
        last = turnings.shape[0] - 1
        turnings[0] = factor * turnings[0]
        turnings[last] = factor * turnings[last]


@kernel
def fill_from_rotations(length: Any, position: Any, turnings: Any) -> None:
    """The same of nodes with rotations, of which the third coordinate is that over 1 / ``length``:
    between those in the middle of two elements, and beyond them at the ends."""
    last = turnings.shape[0] - 1
    over = 1.0 / length
    before = (position[5] - position[2]) * over
    after = (position[8] - position[5]) * over
    turnings[0] = before + 0.5 * (before - after)
    for node in range(1, last):
        i = 3 * node + 2
        after = (position[i + 3] - position[i]) * over
        turnings[node] = 0.5 * (before + after)
        if node == last - 1:
            turnings[last] = after + 0.5 * (after - before)
        before = after


@kernel
def fill_from_edges(position: Any, tangents: Any, turnings: Any) -> None:
    """The same between edges, as discrete rods have it, 2 tan(phi/2); at the ends against the
    clamps' directions."""
    last = turnings.shape[0] - 1
    zero = 0.0 * position[0]
    cx = tangents.left_x
    cy = tangents.left_y
    for j in range(last):
        i = 2 * j
        ex = position[i + 2] - position[i]
        ey = position[i + 3] - position[i + 1]
        edge = make_edge(ex, ey, zero, zero)
        turnings[j] = 2.0 * half_angle_tangent(cx, cy, edge.cx, edge.cy)
        cx = edge.cx
        cy = edge.cy
    turnings[last] = 2.0 * half_angle_tangent(cx, cy, tangents.right_x, tangents.right_y)
