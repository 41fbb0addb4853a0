"""Gaps of the points that can touch the ground, and corrections that leave them open."""

from typing import Any

from snapjump.engine.points import point_at, point_count, share_of
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, any_true, minimum, where

GAP_FRACTION = 0.15  # of its gap that every point keeps in one correction


@kernel
def smallest_gap(model: Any, masses: Any, mesh: Any, state: Any) -> Any:
    """Of all points that can touch the ground (L)."""
    smallest = 1.0e30 + 0.0 * state[0]
    for point in range(point_count(model, masses, mesh)):
        gap = point_at(model, masses, mesh, point, state, state).gap
        share = share_of(model, masses, mesh, point)
        smallest = minimum(smallest, where(share > 0.0, gap, smallest))
    return smallest


@kernel
def limited(share: Any, gap: Any, fall: Any) -> Any:
    """The largest share, at most that given, of a fall that leaves a point GAP_FRACTION."""
    allowed = (1.0 - GAP_FRACTION) * gap
    beyond = fall > allowed
    if any_true(beyond):
        share = minimum(share, where(beyond, allowed / absolute(fall), 1.0))
    return share


@kernel
def keeps_gaps(model: Any) -> Any:
    """Whether corrections must leave gaps open; a constant while compiling."""
    return model.contact.exists() and model.contact.keeps_open()


@kernel
def frame_gap_share(model: Any, masses: Any, mesh: Any, state: Any, drop: Any) -> Any:
    """Share (at most 1) of ``state -= drop`` of the frame's coordinates that keeps open the gaps of
    its own points."""
    share = 1.0 + 0.0 * state[0]
    nodes = masses.shape[0]
    for k in range(model.frame.contact_points(mesh)):
        if any_true(share_of(model, masses, mesh, nodes + k) > 0.0):
            gap, fall = model.frame.fall(mesh, k, state, drop)
            share = limited(share, gap, fall)
    return share


@kernel
def gap_safe_share(
    model: Any, masses: Any, mesh: Any, state: Any, frame_drop: Any, drop: Any
) -> Any:
    """Share of ``state -= drop`` (at most 1) by which no gap shrinks below GAP_FRACTION of it.

    frame_drop: of the frame's coordinates, drop: of the nodes'.
    """
    share = 1.0 + 0.0 * state[0]
    if keeps_gaps(model):
        share = frame_gap_share(model, masses, mesh, state, frame_drop)
        stride = model.discretization.node_dofs()
        for node in range(masses.shape[0]):
            if masses[node] > 0.0:
                row = stride * node + 1
                share = limited(share, state[row + model.frame.dofs(mesh)], drop[row])
    return share
