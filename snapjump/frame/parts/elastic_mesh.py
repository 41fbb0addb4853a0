"""The elastic frame's mesh: an open chain of nodes up the left leg, along the top, down the right.

``mesh`` holds the number of coordinates, the edge of the left mount, and the nodes of the top's
two corners; the right leg mirrors the left one. Edge j joins nodes j and j + 1.
"""

from typing import Any, NamedTuple

from snapjump.discretization.parts.edge import make_edge
from snapjump.number.dispatch import kernel

DOFS, LEFT_MOUNT, LEFT_CORNER, RIGHT_CORNER = range(4)


class Mount(NamedTuple):
    """The middle (x, y) of a mount's edge, the unit vector across it, along the beam (its own
    direction being flat), and the gradient of that direction by the edge's vector (rad/L)."""

    x: Any
    y: Any
    cx: Any
    cy: Any
    slope_x: Any
    slope_y: Any


@kernel
def node_count(mesh: Any) -> Any:
    """Number of the frame's nodes."""
    return mesh[DOFS] // 2


@kernel
def right_mount(mesh: Any) -> Any:
    """The edge of the right mount."""
    return mesh[DOFS] // 2 - 2 - mesh[LEFT_MOUNT]


@kernel
def corner_node(mesh: Any, corner: Any) -> Any:
    """Node of a corner: left foot, left top, right top, right foot."""
    if corner == 0:
        return 0 * mesh[DOFS]
    if corner == 1:
        return mesh[LEFT_CORNER]
    if corner == 2:
        return mesh[RIGHT_CORNER]
    return node_count(mesh) - 1


@kernel
def edge_length(frame: Any, mesh: Any, j: Any) -> Any:
    """Natural length of edge j (L)."""
    last = node_count(mesh) - 2
    if mesh[LEFT_CORNER] <= j and j < mesh[RIGHT_CORNER]:
        return frame.top_length
    k = j if j < mesh[LEFT_CORNER] else last - j
    if k < mesh[LEFT_MOUNT]:
        return frame.low_length
    return frame.mount_length if k == mesh[LEFT_MOUNT] else frame.high_length


@kernel
def node_length(frame: Any, mesh: Any, node: Any) -> Any:
    """Length of the frame that belongs to a node (L)."""
    if node == 0:
        return 0.5 * edge_length(frame, mesh, node)
    if node == node_count(mesh) - 1:
        return 0.5 * edge_length(frame, mesh, node - 1)
    return 0.5 * (edge_length(frame, mesh, node - 1) + edge_length(frame, mesh, node))


@kernel
def node_mass(frame: Any, mesh: Any, node: Any) -> Any:
    """Mass of a node (rho A L), with half of what is clamped at each mount's two nodes."""
    mass = frame.density * node_length(frame, mesh, node)
    left = node - mesh[LEFT_MOUNT]
    right = node - right_mount(mesh)
    if left == 0 or left == 1 or right == 0 or right == 1:
        mass = mass + 0.5 * frame.clamped_mass
    return mass


@kernel
def is_corner(mesh: Any, node: Any) -> Any:
    """Whether a node is a foot or a top corner."""
    foot = node == 0 or node == node_count(mesh) - 1
    return foot or node == mesh[LEFT_CORNER] or node == mesh[RIGHT_CORNER]


@kernel
def mount_at(edge: Any, sign: Any, state: Any) -> Mount:
    """The mount at an edge of the left (``sign`` 1) or right leg (-1)."""
    i = 2 * edge
    zero = 0.0 * state[i]
    along = make_edge(state[i + 2] - state[i], state[i + 3] - state[i + 1], zero, zero)
    return Mount(
        0.5 * (state[i] + state[i + 2]),
        0.5 * (state[i + 1] + state[i + 3]),
        sign * along.cy,
        -sign * along.cx,
        along.slope_x,
        along.slope_y,
    )


@kernel
def weight_at(frame: Any, mesh: Any, node: Any, ground: Any) -> Any:
    """Factor of the contact force at a node."""
    if is_corner(mesh, node):
        return ground.corner_share + 0.0 * frame.node_weight
    return frame.node_weight + frame.length_weight * node_length(frame, mesh, node)
