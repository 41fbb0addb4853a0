"""Discrete elastic rods in the plane: the paper's discretization.

Stretching: xi = |e|/l - 1, energy EA xi^2 l / 2. Bending at a node: kappa = 2 tan(phi/2) / d,
energy EI kappa^2 d / 2, with d the node's length. tan(phi/2) = (e1 x e2) / (|e1||e2| + e1.e2) and
grad phi = (-e_y, e_x)/|e|^2 of either edge: no trigonometry.

A clamp is half an end element with a prescribed tangent (hinge length l/2, second order), or, as
in the paper, two fixed nodes (the chain then starts one element further in, with hinge length l:
first order).
"""

from typing import Any, NamedTuple

from snapjump.damping.base import viscous_stiffening, viscous_strain
from snapjump.discretization.base import (
    ChainPowers,
    EndHinge,
    add_node_forces,
    begin_chain,
    chain_powers,
    clamp_offset,
    end_chain,
    has_elements,
    internal_energy,
)
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, fma, maximum, sqrt


class DiscreteElasticRod(NamedTuple):
    """Element length l, EA, hinge length at a clamp, offset of the clamp (all with EI = L = 1)."""

    element_length: float
    stretching_stiffness: float
    clamp_hinge_length: float
    clamp_offset: float


@has_elements.member(DiscreteElasticRod)
def _has_elements(rod: DiscreteElasticRod) -> bool:
    return True


@clamp_offset.member(DiscreteElasticRod)
def _clamp_offset(rod: DiscreteElasticRod) -> Any:
    return rod.clamp_offset


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
def make_edge(ex: Any, ey: Any, vx: Any, vy: Any) -> Edge:
    """The edge (ex, ey) whose ends move apart with (vx, vy)."""
    length = sqrt(fma(ex, ex, ey * ey))
    over = 1.0 / length
    cx = ex * over
    cy = ey * over
    turn_rate = (cx * vy - cy * vx) * over
    return Edge(length, over, cx, cy, -cy * over, cx * over, turn_rate, cx * vx + cy * vy)


@kernel
def edge_at(j: Any, position: Any, origin: Any, rate_factor: Any) -> Edge:
    """Edge j of the chain; velocities are ``(position - origin) * rate_factor``."""
    ex = position[2 * j + 2] - position[2 * j]
    ey = position[2 * j + 3] - position[2 * j + 1]
    vx = (ex - origin[2 * j + 2] + origin[2 * j]) * rate_factor
    vy = (ey - origin[2 * j + 3] + origin[2 * j + 1]) * rate_factor
    return make_edge(ex, ey, vx, vy)


@kernel
def half_angle_tangent(ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    """tan(phi/2) of the turning angle between two unit vectors."""
    return (ax * by - ay * bx) / (1.0 + ax * bx + ay * by)


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
    return stretching * viscous_strain(damping, edge.length - rod.element_length, edge.stretch_rate)


@kernel
def hinge_moment(damping: Any, t: Any, angle_rate: Any, density: Any, rate_factor: Any) -> Any:
    """dE/dphi of a hinge with t = tan(phi/2), and its derivative with respect to phi.

    ``density`` is one over the hinge's length.
    """
    growth = fma(t, t, 1.0)  # d(2 t)/dphi
    curvature = viscous_strain(damping, 2.0 * t, growth * angle_rate) * density
    elastic = growth * viscous_stiffening(damping, rate_factor) * density
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
    """What a sweep from left to right carries: all about node j that its edges up to j tell.

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
def put_columns(
    node: Any, before: Block, at: Coupling, own: Block, after: Coupling, band: Any
) -> None:
    """Complete the node's columns: edges before and after it, hinges at it and at the next one.

    An edge vector is the difference of its nodes: sums of the edges' blocks are the nodes'.
    """
    i = 2 * node
    band[i, 0] += before.xx + own.xx + 2.0 * at.xx
    band[i, 1] = before.xy + own.xy + (at.xy + at.yx)
    band[i, 2] = -own.xx - at.xx - after.xx
    band[i, 3] = -own.xy - at.yx - after.yx
    band[i, 4] = after.xx
    band[i, 5] = after.yx
    band[i + 1, 0] += before.yy + own.yy + 2.0 * at.yy
    band[i + 1, 1] = -own.xy - at.xy - after.xy
    band[i + 1, 2] = -own.yy - at.yy - after.yy
    band[i + 1, 3] = after.xy
    band[i + 1, 4] = after.yy


@begin_chain.member(DiscreteElasticRod)
def _begin_chain(
    rod: DiscreteElasticRod,
    damping: Any,
    position: Any,
    origin: Any,
    rate_factor: Any,
    tangents: Any,
) -> Any:
    zero = 0.0 * rate_factor
    edge = edge_at(0, position, origin, rate_factor)
    t = half_angle_tangent(tangents.left_x, tangents.left_y, edge.cx, edge.cy)
    rate = edge.turn_rate - tangents.left_rate
    density = 1.0 / rod.clamp_hinge_length
    moment, stiffness = hinge_moment(damping, t, rate, density, rate_factor)
    left = EndHinge(moment, stiffness, edge.slope_x, edge.slope_y)
    chain = Chain(
        edge,
        moment,
        hinge_block(stiffness, edge),
        Coupling(zero, zero, zero, zero),
        Block(zero, zero, zero),
        zero,
        zero,
        absolute(moment),
    )
    return chain, left


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


@add_node_forces.member(DiscreteElasticRod)
def _add_node_forces(
    rod: DiscreteElasticRod,
    damping: Any,
    position: Any,
    origin: Any,
    rate_factor: Any,
    tangents: Any,
    chain: Any,
    node: Any,
    residual: Any,
    band: Any,
) -> Any:
    last = position.shape[0] // 2 - 2  # the last edge
    zero = 0.0 * rate_factor
    edge = chain.edge
    if node < last:
        after = edge_at(node + 1, position, origin, rate_factor)
        density = 1.0 / rod.element_length
    else:
        after = held_end(tangents, zero)
        density = 1.0 / rod.clamp_hinge_length
    t = half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)
    rate = after.turn_rate - edge.turn_rate
    moment, stiffness = hinge_moment(damping, t, rate, density, rate_factor)
    if node == last:
        held = 1.0 - tangents.right_free
        moment = held * moment + tangents.right_free * tangents.right_moment
        stiffness = held * stiffness

    stretching = rod.stretching_stiffness / rod.element_length
    force = axial_force(rod, damping, stretching, edge)
    sideways = (chain.moment - moment) * edge.over
    fx = force * edge.cx - sideways * edge.cy
    fy = force * edge.cy + sideways * edge.cx
    own = edge_block(
        stretching * viscous_stiffening(damping, rate_factor),
        force * edge.over,
        sideways * edge.over,
        edge,
        chain.start,
        hinge_block(stiffness, edge),
    )
    coupling = hinge_coupling(stiffness, edge, after)
    put_columns(node, chain.before, chain.coupling, own, coupling, band)
    residual[2 * node] += chain.force_x - fx
    residual[2 * node + 1] += chain.force_y - fy
    return Chain(
        after,
        moment,
        hinge_block(stiffness, after),
        coupling,
        own,
        fx,
        fy,
        maximum(chain.largest, absolute(fx) + absolute(fy)),
    ), EndHinge(moment, stiffness, edge.slope_x, edge.slope_y)


@end_chain.member(DiscreteElasticRod)
def _end_chain(rod: DiscreteElasticRod, chain: Any, node: Any, residual: Any, band: Any) -> Any:
    i = 2 * node
    band[i, 0] += chain.before.xx
    band[i, 1] = chain.before.xy
    band[i + 1, 0] += chain.before.yy
    for k in range(2, 6):
        band[i, k] = 0.0
        band[i + 1, k - 1] = 0.0
    residual[i] += chain.force_x
    residual[i + 1] += chain.force_y


@internal_energy.member(DiscreteElasticRod)
def _internal_energy(rod: DiscreteElasticRod, position: Any, tangents: Any) -> Any:
    elements = position.shape[0] // 2 - 1
    ax = tangents.left_x
    ay = tangents.left_y
    hinge_length = rod.clamp_hinge_length
    energy = 0.0 * position[0]
    for j in range(elements):
        edge = edge_at(j, position, position, 0.0)
        t = half_angle_tangent(ax, ay, edge.cx, edge.cy)
        energy = energy + stretching_energy(rod, edge.length) + hinge_energy(t, hinge_length)
        ax = edge.cx
        ay = edge.cy
        hinge_length = rod.element_length
    t = half_angle_tangent(ax, ay, tangents.right_x, tangents.right_y)
    last = hinge_energy(t, rod.clamp_hinge_length)
    return energy + (1.0 - tangents.right_free) * last


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


@chain_powers.member(DiscreteElasticRod)
def _chain_powers(
    rod: DiscreteElasticRod, damping: Any, position: Any, velocity: Any, tangents: Any
) -> Any:
    elements = position.shape[0] // 2 - 1
    stretching = rod.stretching_stiffness / rod.element_length
    edge = make_edge(tangents.left_x, tangents.left_y, 0.0 * position[0], 0.0 * position[0])
    rate = tangents.left_rate
    hinge_length = rod.clamp_hinge_length
    zero = 0.0 * position[0]
    power = zero
    moment = zero
    left = zero
    left_x = zero
    left_y = zero
    force = zero
    for j in range(elements):
        after = make_edge(
            position[2 * j + 2] - position[2 * j],
            position[2 * j + 3] - position[2 * j + 1],
            velocity[2 * j + 2] - velocity[2 * j],
            velocity[2 * j + 3] - velocity[2 * j + 1],
        )
        t = half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)
        bending, next_moment = hinge_power(damping, t, after.turn_rate - rate, hinge_length)
        if j == 0:
            left = next_moment
        if j == 1:
            left_x, left_y = edge_force(force, moment - next_moment, edge)
        force = axial_force(rod, damping, stretching, after)
        elastic = stretching * (after.length - rod.element_length)
        power = power + (force - elastic) * after.stretch_rate + bending
        moment = next_moment
        edge = after
        rate = after.turn_rate
        hinge_length = rod.element_length
    t = half_angle_tangent(edge.cx, edge.cy, tangents.right_x, tangents.right_y)
    bending, right = hinge_power(damping, t, tangents.right_rate - rate, rod.clamp_hinge_length)
    held = 1.0 - tangents.right_free
    right = held * right + tangents.right_free * tangents.right_moment
    right_x, right_y = edge_force(force, moment - right, edge)
    return ChainPowers(power + held * bending, left, right, -left_x, -left_y, right_x, right_y)
