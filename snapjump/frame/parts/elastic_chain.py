"""Elasticity of the frame: the elements of the beam's discrete elastic rods, with free ends.

Corners are hinges whose natural angle is right; all others are straight. Bending: kappa =
2 tan(phi/2)/d, energy B (kappa - kappa_0)^2 d / 2, with d the node's length; the natural
tan(phi/2) of both corners is -1 (the chain turns clockwise). There kappa changes twice as fast with
phi as in a straight hinge, so that a corner is four times as stiff as its length of beam: an error
of first order in the mesh, of a few percent of the bending of a frame that hardly bends.
"""

from typing import Any

from snapjump.discretization.base import NodeMotion
from snapjump.discretization.parts.der_elements import (
    Block,
    edge_at,
    edge_block,
    moving_edge,
    put_columns,
    put_last_node,
)
from snapjump.discretization.parts.der_hinges import Coupling, hinge_coupling
from snapjump.discretization.parts.edge import half_angle_tangent
from snapjump.frame.parts.elastic_mesh import (
    LEFT_CORNER,
    RIGHT_CORNER,
    edge_length,
    node_count,
    node_length,
)
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, fma, maximum


@kernel
def natural_tangent(mesh: Any, node: Any) -> float:
    """tan(phi/2) of a hinge without moment."""
    return -1.0 if node == mesh[LEFT_CORNER] or node == mesh[RIGHT_CORNER] else 0.0


@kernel
def hinge(
    frame: Any, mesh: Any, damping: Any, node: Any, before: Any, after: Any, rate_factor: Any
) -> Any:
    """dE/dphi of the hinge at a node between two edges, and its derivative."""
    t = half_angle_tangent(before.cx, before.cy, after.cx, after.cy)
    growth = fma(t, t, 1.0)  # d(2 t)/dphi
    density = frame.bending / node_length(frame, mesh, node)
    rate = growth * (after.turn_rate - before.turn_rate)
    bent = 2.0 * (t - natural_tangent(mesh, node))
    curvature = damping.viscous_strain(bent, rate) * density
    elastic = growth * damping.stiffening(rate_factor) * density
    return curvature * growth, growth * fma(curvature, t, elastic)


@routine
def add_chain_forces(
    frame: Any, mesh: Any, damping: Any, motion: NodeMotion, residual: Any, band: Any
) -> Any:
    """Add gradient and tangent of the frame's elastic (and viscous) energy.

    Rows of residual and band hold masses on the band's diagonal and in the residual; the rest is
    written. Returns the largest element force.
    """
    rate_factor = motion.rate_factor
    zero = 0.0 * rate_factor
    largest = zero
    count = node_count(mesh)
    edge = edge_at(0, motion)
    moment = zero
    before_stiffness = zero
    coupling = Coupling(zero, zero, zero, zero)
    before = Block(zero, zero, zero)
    before_x = zero
    before_y = zero
    for node in range(count - 1):
        after = edge
        next_moment = zero
        stiffness = zero
        if node < count - 2:
            after = edge_at(node + 1, motion)
            next_moment, stiffness = hinge(frame, mesh, damping, node + 1, edge, after, rate_factor)
        length = edge_length(frame, mesh, node)
        stretching = frame.stretching / length
        force = stretching * damping.viscous_strain(edge.length - length, edge.stretch_rate)
        sideways = (moment - next_moment) * edge.over
        fx = force * edge.cx - sideways * edge.cy
        fy = force * edge.cy + sideways * edge.cx
        stretching = stretching * damping.stiffening(rate_factor)
        own = edge_block(stretching, force, sideways, before_stiffness + stiffness, edge)
        next_coupling = hinge_coupling(stiffness, edge, after)
        put_columns(before, coupling, own, next_coupling, band[2 * node :])
        residual[2 * node] += before_x - fx
        residual[2 * node + 1] += before_y - fy
        largest = maximum(largest, absolute(fx) + absolute(fy))
        before = own
        before_x = fx
        before_y = fy
        before_stiffness = stiffness
        coupling = next_coupling
        moment = next_moment
        edge = after
    last = 2 * (count - 1)
    put_last_node(before, (before_x, before_y), residual[last:], band[last:])
    return largest


@routine
def chain_energy(frame: Any, mesh: Any, state: Any) -> Any:
    """Elastic energy of the frame (EI/L)."""
    energy = 0.0 * state[0]
    edge = edge_at(0, NodeMotion(state, state, 0.0))
    for j in range(node_count(mesh) - 1):
        if j > 0:
            after = edge_at(j, NodeMotion(state, state, 0.0))
            t = half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)
            bent = t - natural_tangent(mesh, j)
            energy = energy + 2.0 * frame.bending * bent * bent / node_length(frame, mesh, j)
            edge = after
        length = edge_length(frame, mesh, j)
        strain = edge.length / length - 1.0
        energy = energy + 0.5 * frame.stretching * length * strain * strain
    return energy


@routine
def chain_dissipation(frame: Any, damping: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    """Power that material damping takes out of the frame (EI/(L T))."""
    power = 0.0 * state[0]
    zero = 0.0 * power
    still = edge_at(0, NodeMotion(state, state, zero))
    edge = still
    for j in range(node_count(mesh) - 1):
        after = moving_edge(j, state, velocity)
        resting = edge_at(j, NodeMotion(state, state, zero))
        if j > 0:
            moving, _ = hinge(frame, mesh, damping, j, edge, after, zero)
            elastic, _ = hinge(frame, mesh, damping, j, still, resting, zero)
            power = power + (moving - elastic) * (after.turn_rate - edge.turn_rate)
        length = edge_length(frame, mesh, j)
        strain = after.length - length
        viscous = damping.viscous_strain(strain, after.stretch_rate) - strain
        power = power + frame.stretching / length * viscous * after.stretch_rate
        edge = after
        still = resting
    return power
