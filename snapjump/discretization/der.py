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
    add_internal_forces,
    chain_powers,
    clamp_offset,
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


@kernel
def add_edge(
    j: Any, force: Any, stiffness: Any, turning: Any, edge: Any, residual: Any, band: Any
) -> Any:
    """Add edge j: its axial force and the moment ``turning`` = dE/dtheta on its direction.

    ``stiffness`` is d(force)/d(length). Returns the size of the edge's force.
    """
    cx = edge.cx
    cy = edge.cy
    sideways = turning * edge.over
    fx = force * cx - sideways * cy
    fy = force * cy + sideways * cx
    row = 2 * j
    residual[row] -= fx
    residual[row + 1] -= fy
    residual[row + 2] += fx
    residual[row + 3] += fy
    lateral = force * edge.over
    along = stiffness - lateral
    # Hess theta = [[2 cx cy, cy^2 - cx^2], [cy^2 - cx^2, -2 cx cy]] / |e|^2
    twist = sideways * edge.over
    swing = 2.0 * twist * cx * cy
    kxx = along * cx * cx + lateral + swing
    kxy = along * cx * cy + twist * (cy * cy - cx * cx)
    kyy = along * cy * cy + lateral - swing
    band[row, 0] += kxx
    band[row, 1] += kxy
    band[row, 2] -= kxx
    band[row, 3] -= kxy
    band[row + 1, 0] += kyy
    band[row + 1, 1] -= kxy
    band[row + 1, 2] -= kyy
    band[row + 2, 0] += kxx
    band[row + 2, 1] += kxy
    band[row + 3, 0] += kyy
    return absolute(fx) + absolute(fy)


@kernel
def add_hinge(i: Any, stiffness: Any, ax: Any, ay: Any, bx: Any, by: Any, band: Any) -> None:
    """Add stiffness * g g^T, g = (a, -a - b, b) on nodes i - 1, i, i + 1, to the band."""
    mx = -ax - bx
    my = -ay - by
    row = 2 * i - 2
    kax = stiffness * ax
    kay = stiffness * ay
    kmx = stiffness * mx
    kmy = stiffness * my
    kbx = stiffness * bx
    kby = stiffness * by
    band[row, 0] = fma(kax, ax, band[row, 0])
    band[row, 1] = fma(kax, ay, band[row, 1])
    band[row, 2] = fma(kax, mx, band[row, 2])
    band[row, 3] = fma(kax, my, band[row, 3])
    band[row, 4] = fma(kax, bx, band[row, 4])
    band[row, 5] = fma(kax, by, band[row, 5])
    band[row + 1, 0] = fma(kay, ay, band[row + 1, 0])
    band[row + 1, 1] = fma(kay, mx, band[row + 1, 1])
    band[row + 1, 2] = fma(kay, my, band[row + 1, 2])
    band[row + 1, 3] = fma(kay, bx, band[row + 1, 3])
    band[row + 1, 4] = fma(kay, by, band[row + 1, 4])
    band[row + 2, 0] = fma(kmx, mx, band[row + 2, 0])
    band[row + 2, 1] = fma(kmx, my, band[row + 2, 1])
    band[row + 2, 2] = fma(kmx, bx, band[row + 2, 2])
    band[row + 2, 3] = fma(kmx, by, band[row + 2, 3])
    band[row + 3, 0] = fma(kmy, my, band[row + 3, 0])
    band[row + 3, 1] = fma(kmy, bx, band[row + 3, 1])
    band[row + 3, 2] = fma(kmy, by, band[row + 3, 2])
    band[row + 4, 0] = fma(kbx, bx, band[row + 4, 0])
    band[row + 4, 1] = fma(kbx, by, band[row + 4, 1])
    band[row + 5, 0] = fma(kby, by, band[row + 5, 0])


@kernel
def add_end_hinge(node: Any, other: Any, hinge: Any, band: Any) -> None:
    """Add the end hinge's stiffness on its edge; ``node`` < ``other`` are the edge's nodes."""
    kxx = hinge.stiffness * hinge.slope_x * hinge.slope_x
    kxy = hinge.stiffness * hinge.slope_x * hinge.slope_y
    kyy = hinge.stiffness * hinge.slope_y * hinge.slope_y
    band[2 * node, 0] += kxx
    band[2 * node, 1] += kxy
    band[2 * node, 2] -= kxx
    band[2 * node, 3] -= kxy
    band[2 * node + 1, 0] += kyy
    band[2 * node + 1, 1] -= kxy
    band[2 * node + 1, 2] -= kyy
    band[2 * other, 0] += kxx
    band[2 * other, 1] += kxy
    band[2 * other + 1, 0] += kyy


@add_internal_forces.member(DiscreteElasticRod)
def _add_internal_forces(
    rod: DiscreteElasticRod,
    damping: Any,
    position: Any,
    origin: Any,
    rate_factor: Any,
    tangents: Any,
    residual: Any,
    band: Any,
) -> Any:
    elements = position.shape[0] // 2 - 1
    density = 1.0 / rod.element_length
    end_density = 1.0 / rod.clamp_hinge_length
    stretching = rod.stretching_stiffness * density
    stiffening = stretching * viscous_stiffening(damping, rate_factor)

    edge = edge_at(0, position, origin, rate_factor)
    t = half_angle_tangent(tangents.left_x, tangents.left_y, edge.cx, edge.cy)
    rate = edge.turn_rate - tangents.left_rate
    moment, stiffness = hinge_moment(damping, t, rate, end_density, rate_factor)
    left = EndHinge(moment, stiffness, edge.slope_x, edge.slope_y)
    add_end_hinge(0, 1, left, band)
    largest = absolute(moment)

    for i in range(1, elements):
        after = edge_at(i, position, origin, rate_factor)
        t = half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)
        rate = after.turn_rate - edge.turn_rate
        next_moment, stiffness = hinge_moment(damping, t, rate, density, rate_factor)
        add_hinge(i, stiffness, edge.slope_x, edge.slope_y, after.slope_x, after.slope_y, band)
        force = axial_force(rod, damping, stretching, edge)
        size = add_edge(i - 1, force, stiffening, moment - next_moment, edge, residual, band)
        largest = maximum(largest, size)
        edge = after
        moment = next_moment

    t = half_angle_tangent(edge.cx, edge.cy, tangents.right_x, tangents.right_y)
    rate = tangents.right_rate - edge.turn_rate
    last_moment, stiffness = hinge_moment(damping, t, rate, end_density, rate_factor)
    held = 1.0 - tangents.right_free
    last_moment = held * last_moment + tangents.right_free * tangents.right_moment
    right = EndHinge(last_moment, held * stiffness, edge.slope_x, edge.slope_y)
    add_end_hinge(elements - 1, elements, right, band)
    force = axial_force(rod, damping, stretching, edge)
    size = add_edge(elements - 1, force, stiffening, moment - last_moment, edge, residual, band)
    return left, right, maximum(largest, size)


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
