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
    EndHinge,
    add_internal_forces,
    clamp_offset,
    damping_power,
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


@kernel
def half_angle_tangent(ax: Any, ay: Any, bx: Any, by: Any, lengths: Any) -> Any:
    """tan(phi/2) of the turning angle from vector a to b; ``lengths`` is |a||b|."""
    return (ax * by - ay * bx) / (lengths + ax * bx + ay * by)


@kernel
def stretching_energy(rod: Any, ex: Any, ey: Any) -> Any:
    """Energy of one edge."""
    xi = sqrt(ex * ex + ey * ey) / rod.element_length - 1.0
    return 0.5 * rod.stretching_stiffness * rod.element_length * xi * xi


@kernel
def hinge_energy(ax: Any, ay: Any, bx: Any, by: Any, hinge_length: Any) -> Any:
    """Bending energy between two vectors that meet at a node of the given length."""
    lengths = sqrt(ax * ax + ay * ay) * sqrt(bx * bx + by * by)
    t = half_angle_tangent(ax, ay, bx, by, lengths)
    return 2.0 * t * t / hinge_length


@kernel
def axial_force(rod: Any, damping: Any, length: Any, length_rate: Any) -> Any:
    """Axial force EA (xi + eta d(xi)/dt)."""
    xi = length / rod.element_length - 1.0
    rate = length_rate / rod.element_length
    return rod.stretching_stiffness * viscous_strain(damping, xi, rate)


@kernel
def hinge_moment(damping: Any, t: Any, angle_rate: Any, hinge_length: Any, rate_factor: Any) -> Any:
    """dE/dphi of a hinge with t = tan(phi/2), and its derivative with respect to phi."""
    growth = fma(t, t, 1.0)  # d(2 t)/dphi
    curvature = viscous_strain(damping, 2.0 * t, growth * angle_rate) / hinge_length
    moment = curvature * growth
    stiffness = growth * (
        growth * viscous_stiffening(damping, rate_factor) / hinge_length + curvature * t
    )
    return moment, stiffness


@kernel
def add_edge(j: Any, force: Any, stretching: Any, turning: Any, ex: Any, ey: Any, square: Any,
             length: Any, residual: Any, band: Any) -> Any:
    """Add one edge: axial force, and the moment ``turning`` = dE/dtheta on its direction.

    ``stretching`` is d(force)/d(length). Returns the largest component of the edge's force.
    """
    inverse_square = 1.0 / square
    cx = ex / length
    cy = ey / length
    torque = turning * inverse_square
    fx = force * cx - torque * ey
    fy = force * cy + torque * ex
    residual[2 * j] -= fx
    residual[2 * j + 1] -= fy
    residual[2 * j + 2] += fx
    residual[2 * j + 3] += fy
    lateral = force / length
    along = stretching - lateral
    # Hess theta = [[2 ex ey, ey^2 - ex^2], [ey^2 - ex^2, -2 ex ey]] / |e|^4
    swing = 2.0 * torque * cx * cy
    kxx = along * cx * cx + lateral + swing
    kxy = along * cx * cy + torque * (cy * cy - cx * cx)
    kyy = along * cy * cy + lateral - swing
    band[2 * j, 0] += kxx
    band[2 * j, 1] += kxy
    band[2 * j, 2] -= kxx
    band[2 * j, 3] -= kxy
    band[2 * j + 1, 0] += kyy
    band[2 * j + 1, 1] -= kxy
    band[2 * j + 1, 2] -= kyy
    band[2 * j + 2, 0] += kxx
    band[2 * j + 2, 1] += kxy
    band[2 * j + 3, 0] += kyy
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
    length_0 = rod.element_length
    stretching = (
        rod.stretching_stiffness * viscous_stiffening(damping, rate_factor) / length_0
    )

    ex = position[2] - position[0]
    ey = position[3] - position[1]
    vx = (ex - origin[2] + origin[0]) * rate_factor
    vy = (ey - origin[3] + origin[1]) * rate_factor
    square = ex * ex + ey * ey
    length = sqrt(square)
    bx = -ey / square
    by = ex / square
    turn_rate = bx * vx + by * vy
    force = axial_force(rod, damping, length, (ex * vx + ey * vy) / length)

    t = half_angle_tangent(tangents.left_x, tangents.left_y, ex, ey, length)
    moment, stiffness = hinge_moment(
        damping, t, turn_rate - tangents.left_rate, rod.clamp_hinge_length, rate_factor
    )
    left = EndHinge(moment, stiffness, bx, by)
    add_end_hinge(0, 1, left, band)
    largest = absolute(moment)

    for i in range(1, elements):
        fx = position[2 * i + 2] - position[2 * i]
        fy = position[2 * i + 3] - position[2 * i + 1]
        wx = (fx - origin[2 * i + 2] + origin[2 * i]) * rate_factor
        wy = (fy - origin[2 * i + 3] + origin[2 * i + 1]) * rate_factor
        next_square = fx * fx + fy * fy
        next_length = sqrt(next_square)
        dx = -fy / next_square
        dy = fx / next_square
        next_rate = dx * wx + dy * wy
        t = half_angle_tangent(ex, ey, fx, fy, length * next_length)
        next_moment, stiffness = hinge_moment(
            damping, t, next_rate - turn_rate, length_0, rate_factor
        )
        add_hinge(i, stiffness, bx, by, dx, dy, band)
        size = add_edge(
            i - 1, force, stretching, moment - next_moment, ex, ey, square, length, residual, band
        )
        largest = maximum(largest, size)
        force = axial_force(rod, damping, next_length, (fx * wx + fy * wy) / next_length)
        ex = fx
        ey = fy
        square = next_square
        length = next_length
        bx = dx
        by = dy
        turn_rate = next_rate
        moment = next_moment

    t = half_angle_tangent(ex, ey, tangents.right_x, tangents.right_y, length)
    last_moment, stiffness = hinge_moment(
        damping, t, tangents.right_rate - turn_rate, rod.clamp_hinge_length, rate_factor
    )
    held = 1.0 - tangents.right_free
    last_moment = held * last_moment + tangents.right_free * tangents.right_moment
    right = EndHinge(last_moment, held * stiffness, bx, by)
    add_end_hinge(elements - 1, elements, right, band)
    size = add_edge(
        elements - 1, force, stretching, moment - last_moment, ex, ey, square, length,
        residual, band,
    )
    return left, right, maximum(largest, size)


@internal_energy.member(DiscreteElasticRod)
def _internal_energy(rod: DiscreteElasticRod, position: Any, tangents: Any) -> Any:
    elements = position.shape[0] // 2 - 1
    ax = tangents.left_x
    ay = tangents.left_y
    hinge_length = rod.clamp_hinge_length
    energy = 0.0 * position[0]
    for j in range(elements):
        ex = position[2 * j + 2] - position[2 * j]
        ey = position[2 * j + 3] - position[2 * j + 1]
        energy = energy + stretching_energy(rod, ex, ey)
        energy = energy + hinge_energy(ax, ay, ex, ey, hinge_length)
        ax = ex
        ay = ey
        hinge_length = rod.element_length
    last = hinge_energy(ax, ay, tangents.right_x, tangents.right_y, rod.clamp_hinge_length)
    return energy + (1.0 - tangents.right_free) * last


@damping_power.member(DiscreteElasticRod)
def _damping_power(
    rod: DiscreteElasticRod, damping: Any, position: Any, velocity: Any, tangents: Any
) -> Any:
    elements = position.shape[0] // 2 - 1
    ax = tangents.left_x
    ay = tangents.left_y
    rate = tangents.left_rate
    size = 1.0 + 0.0 * position[0]
    hinge_length = rod.clamp_hinge_length
    power = 0.0 * position[0]
    left = 0.0 * position[0]
    for j in range(elements):
        ex = position[2 * j + 2] - position[2 * j]
        ey = position[2 * j + 3] - position[2 * j + 1]
        vx = velocity[2 * j + 2] - velocity[2 * j]
        vy = velocity[2 * j + 3] - velocity[2 * j + 1]
        length = sqrt(ex * ex + ey * ey)
        length_rate = (ex * vx + ey * vy) / length
        elastic = axial_force(rod, damping, length, 0.0 * length)
        power = power + length_rate * (axial_force(rod, damping, length, length_rate) - elastic)
        turn_rate = (ex * vy - ey * vx) / (length * length)
        t = half_angle_tangent(ax, ay, ex, ey, size * length)
        still, _ = hinge_moment(damping, t, 0.0 * t, hinge_length, 0.0 * t)
        moving, _ = hinge_moment(damping, t, turn_rate - rate, hinge_length, 0.0 * t)
        power = power + (moving - still) * (turn_rate - rate)
        if j == 0:
            left = moving
        ax = ex
        ay = ey
        rate = turn_rate
        size = length
        hinge_length = rod.element_length
    t = half_angle_tangent(ax, ay, tangents.right_x, tangents.right_y, size)
    still, _ = hinge_moment(damping, t, 0.0 * t, rod.clamp_hinge_length, 0.0 * t)
    moving, _ = hinge_moment(damping, t, tangents.right_rate - rate, rod.clamp_hinge_length, 0.0 * t)
    held = 1.0 - tangents.right_free
    power = power + held * (moving - still) * (tangents.right_rate - rate)
    return power, left, held * moving
