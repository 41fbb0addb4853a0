"""Edges of a discrete elastic rod, which stretch, and the rows of nodes between them.

Each function is local: one edge, or one node. :mod:`snapjump.discretization.der`
sums them along the chain.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import NodeMotion
from snapjump.discretization.parts.der_hinges import Coupling, Side
from snapjump.discretization.parts.der_skew import SkewChain
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
def stretching_energy(rod: Any, length: Any) -> Any:
    """Energy of one edge of the given length."""
    xi = length / rod.element_length - 1.0
    return 0.5 * rod.stretching_stiffness * rod.element_length * xi * xi


@kernel
def axial_force(rod: Any, damping: Any, stretching: Any, edge: Any) -> Any:
    """Axial force EA (xi + eta d(xi)/dt); ``stretching`` is EA over the element's length."""
    return stretching * damping.viscous_strain(edge.length - rod.element_length, edge.stretch_rate)


class Block(NamedTuple):
    """A symmetric 2 x 2 block of the Hessian with respect to edge vectors (EI/L^3)."""

    xx: Any
    xy: Any
    yy: Any


class Chain(NamedTuple):
    """State of a sweep from left to right: all about node j that its edges up to j tell.

    edge: edge j, which leaves the node; moment, stiffness: of the hinge at the node; coupling: of
    the edges at the node; before, force_x, force_y: block and force of edge
    j - 1; largest: force of an edge so far; after: edge j + 1, or the clamp; skew: what of this
    only derivatives ask for.
    """

    edge: Side
    moment: Any
    stiffness: Any
    coupling: Coupling
    before: Block
    force_x: Any
    force_y: Any
    largest: Any
    after: Side
    skew: SkewChain


@kernel
def side_of(rod: Any, damping: Any, edge: Edge) -> Side:
    """What an edge contributes to the nodes and hinges on either side."""
    stretching = rod.stretching_stiffness / rod.element_length
    force = axial_force(rod, damping, stretching, edge)
    return Side(edge.over, edge.cx, edge.cy, edge.turn_rate, edge.stretch_rate, force)


@kernel
def held_edge(x: Any, y: Any, rate: Any, zero: Any) -> Side:
    """A clamp as an edge beyond the chain's end, of a given direction, that does not give way."""
    return Side(zero, x + zero, y + zero, rate + zero, zero, zero)


@kernel
def right_clamp(tangents: Any, zero: Any) -> Side:
    """The clamp on the right."""
    return held_edge(tangents.right_x, tangents.right_y, tangents.right_rate, zero)


@kernel
def edge_block(stiffness: Any, force: Any, sideways: Any, hinges: Any, edge: Any) -> Block:
    """Hessian with respect to an edge vector: its stretching and turning, and both its hinges.

    stiffness: d(force)/d(length); sideways: the force across; hinges: the sum of their stiffness.
    With t along the edge and n across it this is stiffness t t^T + swing n n^T - twist (t n^T +
    n t^T), since Hess theta = -(t n^T + n t^T) / |e|^2.
    """
    over = edge.over
    swing = over * fma(hinges, over, force)
    twist = sideways * over
    along = stiffness - swing
    square = edge.cx * edge.cx
    product = edge.cx * edge.cy
    xx = fma(along, square, fma(twist + twist, product, swing))
    xy = fma(along, product, -(twist * (square + square - 1.0)))
    return Block(xx, xy, (stiffness + swing) - xx)


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
