"""Elements of a discrete elastic rod: edges that stretch, hinges that bend.

Each function is local: one edge, or the hinge between two. :mod:`snapjump.discretization.der`
sums them along the chain.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import NodeMotion
from snapjump.discretization.parts.edge import Edge, make_edge
from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma


@kernel
def edge_at(j: Any, nodes: NodeMotion) -> Edge:
    """Edge j of the chain, which moves as its nodes do."""
    position = nodes.position
    predictor = nodes.predictor
    ex = position[2 * j + 2] - position[2 * j]
    ey = position[2 * j + 3] - position[2 * j + 1]
    vx = (ex - predictor[2 * j + 2] + predictor[2 * j]) * nodes.rate_factor
    vy = (ey - predictor[2 * j + 3] + predictor[2 * j + 1]) * nodes.rate_factor
    return make_edge(ex, ey, vx, vy)


@kernel
def moving_edge(j: Any, position: Any, velocity: Any) -> Edge:
    """Edge j of a chain whose nodes have these places and velocities."""
    i = 2 * j
    return make_edge(
        position[i + 2] - position[i],
        position[i + 3] - position[i + 1],
        velocity[i + 2] - velocity[i],
        velocity[i + 3] - velocity[i + 1],
    )


@kernel
def held_end(tangents: Any, zero: Any) -> Edge:
    """The clamp on the right as an edge that follows the last one and does not give way."""
    return Edge(
        zero + 1.0,
        zero,
        tangents.right_x + zero,
        tangents.right_y + zero,
        zero,
        zero,
        tangents.right_rate + zero,
        zero,
    )


@kernel
def stretching_energy(rod: Any, length: Any) -> Any:
    """Energy of one edge of the given length."""
    xi = length / rod.element_length - 1.0
    return 0.5 * rod.stretching_stiffness * rod.element_length * xi * xi


@kernel
def hinge_energy(t: Any, hinge_length: Any) -> Any:
    """Bending energy of a node of the given length with t = tan(phi/2)."""
    return 2.0 * t * t / hinge_length


@kernel
def axial_force(rod: Any, damping: Any, stretching: Any, edge: Any) -> Any:
    """Axial force EA (xi + eta d(xi)/dt); ``stretching`` is EA over the element's length."""
    return stretching * damping.viscous_strain(edge.length - rod.element_length, edge.stretch_rate)


@kernel
def hinge_moment(damping: Any, t: Any, angle_rate: Any, density: Any, rate_factor: Any) -> Any:
    """dE/dphi of a hinge with t = tan(phi/2), and its derivative with respect to phi.

    ``density`` is one over the hinge's length.
    """
    growth = fma(t, t, 1.0)  # d(2 t)/dphi
    curvature = damping.viscous_strain(2.0 * t, growth * angle_rate) * density
    elastic = growth * damping.stiffening(rate_factor) * density
    return curvature * growth, growth * fma(curvature, t, elastic)


class Block(NamedTuple):
    """A symmetric 2 x 2 block of the Hessian with respect to edge vectors (EI/L^3)."""

    xx: Any
    xy: Any
    yy: Any


class Coupling(NamedTuple):
    """Minus the Hessian's block of a hinge's edge after (row) and its edge before (column)."""

    xx: Any
    xy: Any
    yx: Any
    yy: Any


class Chain(NamedTuple):
    """State of a sweep from left to right: all about node j that its edges up to j tell.

    edge: edge j, which leaves the node; moment: of the hinge at the node; start: that hinge's
    stiffness on edge j; coupling: of the edges at the node; before, force_x, force_y: block and
    force of edge j - 1; largest: force of an edge so far.
    """

    edge: Edge
    moment: Any
    start: Block
    coupling: Coupling
    before: Block
    force_x: Any
    force_y: Any
    largest: Any


@kernel
def hinge_block(stiffness: Any, edge: Edge) -> Block:
    """stiffness * g g^T, g being the gradient of an edge's direction."""
    x = stiffness * edge.slope_x
    y = stiffness * edge.slope_y
    return Block(x * edge.slope_x, x * edge.slope_y, y * edge.slope_y)


@kernel
def hinge_coupling(stiffness: Any, before: Edge, after: Edge) -> Coupling:
    """stiffness * g h^T, g and h being the gradients of the two edges' directions."""
    x = stiffness * after.slope_x
    y = stiffness * after.slope_y
    return Coupling(x * before.slope_x, x * before.slope_y, y * before.slope_x, y * before.slope_y)


@kernel
def edge_block(
    stiffness: Any, lateral: Any, twist: Any, edge: Edge, start: Block, end: Block
) -> Block:
    """Hessian with respect to an edge vector: its stretching and turning, and both its hinges.

    ``stiffness`` is d(force)/d(length), ``lateral`` force over length, ``twist`` moment over
    length squared: Hess theta = [[2 cx cy, cy^2 - cx^2], [cy^2 - cx^2, -2 cx cy]] / |e|^2.
    """
    cx = edge.cx
    cy = edge.cy
    along = stiffness - lateral
    swing = 2.0 * twist * cx * cy
    return Block(
        fma(along * cx, cx, lateral + swing) + (start.xx + end.xx),
        fma(along * cx, cy, twist * (cy * cy - cx * cx)) + (start.xy + end.xy),
        fma(along * cy, cy, lateral - swing) + (start.yy + end.yy),
    )


@kernel
def put_columns(before: Block, at: Coupling, own: Block, after: Coupling, band: Any) -> None:
    """Complete a node's columns: edges before and after it, hinges at it and at the next one.

    An edge vector is the difference of its nodes: sums of the edges' blocks are the nodes'.
    """
    band[0, 0] += before.xx + own.xx + 2.0 * at.xx
    band[0, 1] = before.xy + own.xy + (at.xy + at.yx)
    band[0, 2] = -own.xx - at.xx - after.xx
    band[0, 3] = -own.xy - at.yx - after.yx
    band[0, 4] = after.xx
    band[0, 5] = after.yx
    band[1, 0] += before.yy + own.yy + 2.0 * at.yy
    band[1, 1] = -own.xy - at.xy - after.xy
    band[1, 2] = -own.yy - at.yy - after.yy
    band[1, 3] = after.xy
    band[1, 4] = after.yy


@kernel
def hinge_power(damping: Any, t: Any, angle_rate: Any, hinge_length: Any) -> Any:
    """Power that damping takes out of a hinge, and the hinge's moment."""
    zero = 0.0 * t
    density = 1.0 / hinge_length
    still, _ = hinge_moment(damping, t, zero, density, zero)
    moving, _ = hinge_moment(damping, t, angle_rate, density, zero)
    return (moving - still) * angle_rate, moving


@kernel
def edge_force(force: Any, turning: Any, edge: Any) -> Any:
    """Gradient of the energy with respect to the edge vector."""
    sideways = turning * edge.over
    return force * edge.cx - sideways * edge.cy, force * edge.cy + sideways * edge.cx


@kernel
def put_last_node(before: Block, force: Any, residual: Any, band: Any) -> None:
    """Complete the last node's columns and its residual: ``before`` and ``force`` (x, y) are those
    of the last edge."""
    band[0, 0] += before.xx
    band[0, 1] = before.xy
    band[1, 0] += before.yy
    for k in range(2, 6):
        band[0, k] = 0.0
        band[1, k - 1] = 0.0
    residual[0] += force[0]
    residual[1] += force[1]
