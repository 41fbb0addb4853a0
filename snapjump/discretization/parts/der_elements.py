"""Elements of a discrete elastic rod: edges that stretch, hinges that bend.

Each function is local: one edge, or the hinge between two. :mod:`snapjump.discretization.der`
sums them along the chain.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndHinge, NodeMotion
from snapjump.discretization.parts.der_skew import Pull, SkewChain, hinge_pull, share_of_pull
from snapjump.discretization.parts.edge import Edge, half_angle_tangent, make_edge
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
    elastic = growth * (damping.stiffening(rate_factor) * density)
    return curvature * growth, growth * fma(curvature, t, elastic)


class Hinge(NamedTuple):
    """Moment dE/dphi of a hinge, its derivative by phi, and what both lack of its derivative."""

    moment: Any
    stiffness: Any
    pull: Pull


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


class Side(NamedTuple):
    """An edge as its neighbours see it: one over its length (1/L), unit tangent, the rates of its
    direction (rad/T) and of its length (L/T), and its axial force (EI/L^2)."""

    over: Any
    cx: Any
    cy: Any
    turn_rate: Any
    stretch_rate: Any
    force: Any


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
def hinge_between(damping: Any, before: Side, after: Side, density: Any, rate_factor: Any) -> Hinge:
    """The hinge between two edges; ``density``: one over its length."""
    t = half_angle_tangent(before.cx, before.cy, after.cx, after.cy)
    angle_rate = after.turn_rate - before.turn_rate
    moment, stiffness = hinge_moment(damping, t, angle_rate, density, rate_factor)
    return Hinge(moment, stiffness, hinge_pull(damping, t, before, after, density))


@kernel
def right_clamp(tangents: Any, zero: Any) -> Side:
    """The clamp on the right."""
    return held_edge(tangents.right_x, tangents.right_y, tangents.right_rate, zero)


@kernel
def held_hinge(
    rod: Any, damping: Any, edge: Side, clamp: Side, tangents: Any, nodes: NodeMotion
) -> Hinge:
    """The hinge at the clamp on the right, which may be free."""
    density = 1.0 / rod.clamp_hinge_length
    hinge = hinge_between(damping, edge, clamp, density, nodes.rate_factor)
    share = 1.0 - tangents.right_free
    return Hinge(
        share * hinge.moment + tangents.right_free * tangents.right_moment,
        share * hinge.stiffness,
        share_of_pull(share, hinge.pull),
    )


@kernel
def end_hinge(hinge: Hinge, edge: Side, rate_x: Any, rate_y: Any) -> EndHinge:
    """The hinge at a clamp, of an end edge; ``rate_x``, ``rate_y``: that edge's of its pull."""
    return EndHinge(
        hinge.moment,
        hinge.stiffness,
        -edge.cy * edge.over,
        edge.cx * edge.over,
        rate_x,
        rate_y,
        hinge.pull.turned,
    )


@kernel
def hinge_coupling(stiffness: Any, before: Any, after: Any) -> Coupling:
    """stiffness * g h^T, g and h being the gradients (-cy, cx) / length of the two edges'
    directions."""
    scale = stiffness * (before.over * after.over)
    x = scale * after.cy
    y = scale * after.cx
    return Coupling(x * before.cy, -(x * before.cx), -(y * before.cy), y * before.cx)


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
