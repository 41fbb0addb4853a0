"""What the symmetric tangent of discrete elastic rods lacks, for derivatives that are exact.

A viscous force is gradient times (elastic + viscous strain rate), and the rate depends on the edges
not only by their velocities: d(stretch rate)/de = w n and d(turn rate)/de = -(s n / |e| + w t)/|e|
of an edge e with tangent t, normal n, turn rate w and stretch rate s. Newton's method does without.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import HALF_BANDWIDTH, RIGHT
from snapjump.number.dispatch import kernel


class Pull(NamedTuple):
    """What a hinge's derivatives lack: by the edge before it and by the one after it (EI/L^2), and,
    in these, by its angle (EI/L)."""

    bx: Any
    by: Any
    ax: Any
    ay: Any
    turned: Any


class Square(NamedTuple):
    """A 2 x 2 block (EI/L^3)."""

    xx: Any
    xy: Any
    yx: Any
    yy: Any


class SkewChain(NamedTuple):
    """Carried from node to node: the block of edge j - 1 and of the hinge before it, the pull of
    the hinge at the node, and the gradient of the direction of edge j - 1."""

    before: Square
    pull: Pull
    slope_x: Any
    slope_y: Any


@kernel
def viscosity(damping: Any) -> Any:
    """d viscous_strain / d rate."""
    return damping.stiffening(1.0) - damping.stiffening(0.0)


@kernel
def pull_of_edge(edge: Any, turned: Any, rate: Any) -> Any:
    """turned g + rate d(turn rate)/de, g being the gradient of the edge's direction."""
    sideways = (turned - rate * edge.stretch_rate * edge.over) * edge.over
    along = rate * edge.turn_rate * edge.over
    return -sideways * edge.cy - along * edge.cx, sideways * edge.cx - along * edge.cy


@kernel
def hinge_pull(damping: Any, t: Any, before: Any, after: Any, density: Any) -> Pull:
    """The pull of a hinge with t = tan(phi/2)."""
    growth = t * t + 1.0
    rate = growth * growth * (viscosity(damping) * density)
    turned = rate * t * (after.turn_rate - before.turn_rate)
    bx, by = pull_of_edge(before, turned, rate)
    ax, ay = pull_of_edge(after, turned, rate)
    return Pull(-bx, -by, ax, ay, turned)


@kernel
def share_of_pull(share: Any, pull: Pull) -> Pull:
    """A share of a pull."""
    return Pull(
        share * pull.bx, share * pull.by, share * pull.ax, share * pull.ay, share * pull.turned
    )


@kernel
def begin_skew(pull: Pull, zero: Any) -> SkewChain:
    """At the first node, with the pull of the clamp's hinge."""
    return SkewChain(Square(zero, zero, zero, zero), pull, zero, zero)


@kernel
def outer(gx: Any, gy: Any, px: Any, py: Any) -> Square:
    """g p^T."""
    return Square(gx * px, gx * py, gy * px, gy * py)


@kernel
def sum_of(a: Square, b: Square) -> Square:
    """a + b."""
    return Square(a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy)


@kernel
def add_diagonal(block: Square, skew: Any) -> None:
    """Add a node's own block."""
    skew[0, 0] += block.xx
    skew[0, 1] += block.yx
    skew[0, RIGHT] += block.xy
    skew[1, 0] += block.yy


@kernel
def put_below(block: Square, k: Any, skew: Any) -> None:
    """Write the block of a later node's rows, ``k`` below this one's x, and this one's columns."""
    skew[0, k] = block.xx
    skew[0, k + 1] = block.yx
    skew[1, k - 1] = block.xy
    skew[1, k] = block.yy


@kernel
def put_right(block: Square, k: Any, skew: Any) -> None:
    """Write the block of this node's rows and a later one's columns."""
    skew[0, HALF_BANDWIDTH + k] = block.xx
    skew[0, HALF_BANDWIDTH + k + 1] = block.xy
    skew[1, HALF_BANDWIDTH + k - 1] = block.yx
    skew[1, HALF_BANDWIDTH + k] = block.yy


@kernel
def add_skew(
    damping: Any, stretching: Any, chain: SkewChain, edge: Any, after: Any, pull: Pull, skew: Any
) -> SkewChain:
    """Add what a node's rows and columns lack: ``edge`` leaves it, ``after`` follows, and ``pull``
    is that of the hinge between them; ``stretching``: EA over the element's length.

    A hinge's force on its three nodes is moment times (g_b, -g_b - g_a, g_a), with the gradients of
    both edges' directions, and its pull on them (-b, b - a, a).
    """
    at = chain.pull
    gx = -edge.cy * edge.over
    gy = edge.cx * edge.over
    fx = -after.cy * after.over
    fy = after.cx * after.over
    at_x = -chain.slope_x - gx
    at_y = -chain.slope_y - gy
    viscous = stretching * viscosity(damping) * edge.turn_rate
    own = outer(viscous * edge.cx, viscous * edge.cy, -edge.cy, edge.cx)
    here = sum_of(
        sum_of(chain.before, own),
        sum_of(outer(at_x, at_y, at.bx - at.ax, at.by - at.ay), outer(-gx, -gy, pull.bx, pull.by)),
    )
    add_diagonal(here, skew)
    negative = Square(-own.xx, -own.xy, -own.yx, -own.yy)
    right = sum_of(
        outer(at_x, at_y, at.ax, at.ay), outer(gx, gy, pull.bx - pull.ax, pull.by - pull.ay)
    )
    put_right(sum_of(right, negative), 2, skew)
    put_right(outer(gx, gy, pull.ax, pull.ay), 4, skew)
    below = sum_of(
        outer(gx, gy, at.bx - at.ax, at.by - at.ay), outer(gx + fx, gy + fy, pull.bx, pull.by)
    )
    put_below(sum_of(below, negative), 2, skew)
    put_below(outer(-fx, -fy, pull.bx, pull.by), 4, skew)
    return SkewChain(sum_of(own, outer(gx, gy, at.ax, at.ay)), pull, gx, gy)


@kernel
def end_skew(chain: SkewChain, skew: Any) -> None:
    """Add what the last node's rows and columns lack."""
    at = chain.pull
    clamp = outer(-chain.slope_x, -chain.slope_y, at.bx, at.by)
    add_diagonal(sum_of(chain.before, clamp), skew)
