"""A wall on the left, nothing on the right: the cantilever of the verification scene."""

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
from snapjump.frame.ends import release_first_node
from snapjump.load.base import tip_load
from snapjump.number.functions import cos, sin


class CantileverFrame(NamedTuple):
    """The left end clamped at the origin."""


@frame_dofs.member(CantileverFrame)
def _frame_dofs(frame: CantileverFrame) -> int:
    return 0


@end_tangents.member(CantileverFrame)
def _end_tangents(frame: CantileverFrame, load: Any, angles: Any, state: Any, velocity: Any) -> Any:
    zero = 0.0 * state[0]
    _, _, moment = tip_load(load)
    return EndTangents(
        cos(angles.left),
        -sin(angles.left),
        -angles.left_rate,
        zero + 1.0,
        zero,
        zero,
        zero + 1.0,
        zero + moment,
    )


@place_ends.member(CantileverFrame)
def _place_ends(frame: CantileverFrame, discretization: Any, angles: Any, state: Any) -> None:
    offset = clamp_offset(discretization)
    state[0] = offset * cos(angles.left)
    state[1] = -offset * sin(angles.left)
    if node_dofs(discretization) == 3:
        state[2] = -turn_length(discretization) * angles.left


@condense_first.member(CantileverFrame)
def _condense_first(
    frame: CantileverFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    release_first_node(node_dofs(discretization), system.residual, system.band)


@condense_last.member(CantileverFrame)
def _condense_last(
    frame: CantileverFrame, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> None:
    pass


@add_frame_forces.member(CantileverFrame)
def _add_frame_forces(frame: CantileverFrame, model: Any, motion: Any, work: Any) -> Any:
    zero = 0.0 * motion.rate_factor
    return FrameForces(zero, zero + 1.0e30, zero)


@limit_frame_step.member(CantileverFrame)
def _limit_frame_step(frame: CantileverFrame, state: Any, drop: Any, fraction: Any) -> Any:
    return 1.0 + 0.0 * state[0]


@corner_point.member(CantileverFrame)
def _corner_point(frame: CantileverFrame, corner: Any, state: Any, velocity: Any) -> Any:
    zero = 0.0 * state[0]
    return zero, zero, zero, zero


@corner_mass.member(CantileverFrame)
def _corner_mass(frame: CantileverFrame, corner: Any, state: Any) -> float:
    return 0.0


@frame_mass.member(CantileverFrame)
def _frame_mass(frame: CantileverFrame, coordinate: Any) -> float:
    return 0.0
