"""Elements with a rotation at either end: the contract of one element, and what all share.

An element is straight at rest. Its energy depends on the vector e = (ex, ey) from its first node
to its second, on the mean theta_m of the two nodes' rotations and on their difference: bending is
EI (theta_2 - theta_1)^2 / (2 l) for all, the rest is each member's own. Only differences of
rotations along the chain and their sine and cosine count, so that turns of more than pi do no harm.
"""

from typing import Any, NamedTuple

from snapjump.number.dispatch import kernel


class Span(NamedTuple):
    """Relative motion of an element's nodes: vector between them (L), mean rotation (rad), their
    rates, and d(rate)/d(position) of the integrator (1/T)."""

    ex: Any
    ey: Any
    turn: Any
    vx: Any
    vy: Any
    turn_rate: Any
    rate_factor: Any


class Straining(NamedTuple):
    """Gradient (force_x, force_y, torque) and Hessian of an element's energy, apart from bending,
    with respect to (ex, ey, theta_m)."""

    force_x: Any
    force_y: Any
    torque: Any
    xx: Any
    xy: Any
    yy: Any
    xt: Any
    yt: Any
    tt: Any


class Element(NamedTuple):
    """Gradient and Hessian of an element's energy with respect to e and the third coordinates s
    of its nodes: dE/ds_1 = torque - moment, dE/ds_2 = torque + moment; xs, ys: d2E/de ds of
    either; same: d2E/ds_1^2 = d2E/ds_2^2; cross: d2E/ds_1 ds_2."""

    force_x: Any
    force_y: Any
    torque: Any
    moment: Any
    xx: Any
    xy: Any
    yy: Any
    xs: Any
    ys: Any
    same: Any
    cross: Any


@kernel
def element_of(
    discretization: Any, damping: Any, span: Span, bend: Any, bend_rate: Any, over: Any
) -> Element:
    """An element with its bending; ``over`` is 1 / l, d(theta)/ds, ``bend`` theta_2 - theta_1."""
    own = discretization.strain_element(damping, span)
    half = 0.5 * over
    squared = over * over
    # EI / l, and 1 / l once more for either s.
    moment = squared * damping.viscous_strain(bend, bend_rate)
    stiffness = squared * over * damping.stiffening(span.rate_factor)
    turning = 0.25 * squared * own.tt
    return Element(
        own.force_x,
        own.force_y,
        half * own.torque,
        moment,
        own.xx,
        own.xy,
        own.yy,
        half * own.xt,
        half * own.yt,
        turning + stiffness,
        turning - stiffness,
    )
