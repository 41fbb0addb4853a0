"""Sliding that Newton's method has yet to settle: a foot that sticks must not flip its friction.

A correction of the state that is small against the tolerance may still be, divided by the step, a
velocity across the whole zone in which friction changes sign.
"""

from typing import Any

from snapjump.engine.points import point_at, point_count, share_of
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, any_true, maximum, minimum, where


@kernel
def settles_sliding(model: Any) -> Any:
    """Whether friction is of the sliding velocity that is being solved for."""
    return model.contact.exists() and model.friction.exists() and not model.friction.is_lagged()


@routine
def unsettled_sliding(model: Any, rate_factor: Any, masses: Any, work: Any) -> Any:
    """Largest change of a sliding velocity (L/T) in the last correction, of all points that it
    brings near the zone of sticking, through it, or out of it."""
    mesh = work.mesh
    reach = model.contact.reach()
    zone = 2.0 * model.friction.stick_speed()
    largest = 0.0 * rate_factor
    for point in range(point_count(model, masses, mesh)):
        moved = point_at(model, masses, mesh, point, work.state, work.correction)
        touching = (moved.gap < reach) & (share_of(model, masses, mesh, point) > 0.0)
        if any_true(touching):
            change = moved.vx * rate_factor
            before = work.sliding_velocity[point]
            after = before - change
            near = minimum(absolute(before), absolute(after)) < zone
            sticks = touching & (near | (before * after < 0.0))
            largest = maximum(largest, where(sticks, absolute(change), 0.0))
    return largest
