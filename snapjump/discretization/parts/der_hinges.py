"""Hinges of a discrete elastic rod: what bends at a node, and at a clamp."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndHinge, NodeMotion
from snapjump.discretization.parts.der_skew import Pull, hinge_pull, share_of_pull
from snapjump.discretization.parts.edge import half_angle_tangent
from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma


class Side(NamedTuple):
    """An edge as its neighbours see it: one over its length (1/L), unit tangent, the rates of its
    direction (rad/T) and of its length (L/T), and its axial force (EI/L^2)."""

    over: Any
    cx: Any
    cy: Any
    turn_rate: Any
    stretch_rate: Any
    force: Any


@kernel
def hinge_energy(t: Any, hinge_length: Any) -> Any:
    """Bending energy of a node of the given length with t = tan(phi/2)."""
    return 2.0 * t * t / hinge_length


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


class Coupling(NamedTuple):
    """Minus the Hessian's block of a hinge's edge after (row) and its edge before (column)."""

    xx: Any
    xy: Any
    yx: Any
    yy: Any


@kernel
def hinge_between(damping: Any, before: Side, after: Side, density: Any, rate_factor: Any) -> Hinge:
    """The hinge between two edges; ``density``: one over its length."""
    t = half_angle_tangent(before.cx, before.cy, after.cx, after.cy)
    angle_rate = after.turn_rate - before.turn_rate
    moment, stiffness = hinge_moment(damping, t, angle_rate, density, rate_factor)
    return Hinge(moment, stiffness, hinge_pull(damping, t, before, after, density))


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
def hinge_power(damping: Any, t: Any, angle_rate: Any, hinge_length: Any) -> Any:
    """Power that damping takes out of a hinge, and the hinge's moment."""
    zero = 0.0 * t
    density = 1.0 / hinge_length
    still, _ = hinge_moment(damping, t, zero, density, zero)
    moving, _ = hinge_moment(damping, t, angle_rate, density, zero)
    return (moving - still) * angle_rate, moving
