"""A frame that does not move: both clamps are held in space."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents, clamp_offset, node_dofs, turn_length
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
from snapjump.frame.ends import release_first_node, release_last_node
from snapjump.number.functions import cos, sin


class FixedFrame(NamedTuple):
    """Half the clear span, and the height of both mounts (in L)."""

    half_span: float
    mount_height: float


@frame_dofs.member(FixedFrame)
def _frame_dofs(frame: FixedFrame) -> int:
    return 0


@end_tangents.member(FixedFrame)
def _end_tangents(frame: FixedFrame, load: Any, angles: Any, state: Any, velocity: Any) -> Any:
    return EndTangents(
        cos(angles.left),
        -sin(angles.left),
        -angles.left_rate,
        cos(angles.right),
        sin(angles.right),
        angles.right_rate,
        0.0 * angles.left,
        0.0 * angles.left,
    )


@place_ends.member(FixedFrame)
def _place_ends(frame: FixedFrame, discretization: Any, angles: Any, state: Any) -> None:
    dofs = node_dofs(discretization)
    offset = clamp_offset(discretization)
    last = state.shape[0] - dofs
    state[0] = -frame.half_span + offset * cos(angles.left)
    state[1] = frame.mount_height - offset * sin(angles.left)
    state[last] = frame.half_span - offset * cos(angles.right)
    state[last + 1] = frame.mount_height - offset * sin(angles.right)
    if dofs == 3:
        state[2] = -turn_length(discretization) * angles.left
        state[last + 2] = turn_length(discretization) * angles.right


@condense_first.member(FixedFrame)
def _condense_first(
    frame: FixedFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    release_first_node(node_dofs(discretization), system.residual, system.band)


@condense_last.member(FixedFrame)
def _condense_last(
    frame: FixedFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    dofs = node_dofs(discretization)
    release_last_node(dofs, system.residual, system.band, state.shape[0] // dofs - 1)


@add_frame_forces.member(FixedFrame)
def _add_frame_forces(frame: FixedFrame, model: Any, motion: Any, work: Any) -> Any:
    zero = 0.0 * motion.rate_factor
    return FrameForces(zero, zero + 1.0e30, zero)


@limit_frame_step.member(FixedFrame)
def _limit_frame_step(frame: FixedFrame, state: Any, drop: Any, fraction: Any) -> Any:
    return 1.0 + 0.0 * state[0]


@corner_point.member(FixedFrame)
def _corner_point(frame: FixedFrame, corner: Any, state: Any, velocity: Any) -> Any:
    zero = 0.0 * state[0]
    return zero, zero, zero, zero


@corner_mass.member(FixedFrame)
def _corner_mass(frame: FixedFrame, corner: Any, state: Any) -> float:
    return 0.0


@frame_mass.member(FixedFrame)
def _frame_mass(frame: FixedFrame, coordinate: Any) -> float:
    return 0.0
