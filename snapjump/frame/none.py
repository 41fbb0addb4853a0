"""No frame: loose nodes that only contact and friction act on."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
from snapjump.frame.base import (
    FrameForces,
    add_frame_forces,
    condense_first,
    condense_last,
    corner_mass,
    corner_point,
    end_tangents,
    frame_dofs,
    frame_mass,
    limit_frame_step,
    place_ends,
)


class NoFrame(NamedTuple):
    """Nothing is held."""


@frame_dofs.member(NoFrame)
def _frame_dofs(frame: NoFrame) -> int:
    return 0


@end_tangents.member(NoFrame)
def _end_tangents(frame: NoFrame, load: Any, angles: Any, state: Any, velocity: Any) -> Any:
    zero = 0.0 * state[0]
    return EndTangents(zero, zero, zero, zero, zero, zero, zero, zero)


@place_ends.member(NoFrame)
def _place_ends(frame: NoFrame, discretization: Any, angles: Any, state: Any) -> None:
    pass


@condense_first.member(NoFrame)
def _condense_first(
    frame: NoFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    pass


@condense_last.member(NoFrame)
def _condense_last(
    frame: NoFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    pass


@add_frame_forces.member(NoFrame)
def _add_frame_forces(frame: NoFrame, model: Any, motion: Any, work: Any) -> Any:
    zero = 0.0 * motion.rate_factor
    return FrameForces(zero, zero + 1.0e30, zero)


@limit_frame_step.member(NoFrame)
def _limit_frame_step(frame: NoFrame, state: Any, drop: Any, fraction: Any) -> Any:
    return 1.0 + 0.0 * state[0]


@corner_point.member(NoFrame)
def _corner_point(frame: NoFrame, corner: Any, state: Any, velocity: Any) -> Any:
    zero = 0.0 * state[0]
    return zero, zero, zero, zero


@corner_mass.member(NoFrame)
def _corner_mass(frame: NoFrame, corner: Any, state: Any) -> float:
    return 0.0


@frame_mass.member(NoFrame)
def _frame_mass(frame: NoFrame, coordinate: Any) -> float:
    return 0.0
