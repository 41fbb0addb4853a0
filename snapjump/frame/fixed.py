"""A frame that does not move: both clamps are held in space."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents, clamp_offset, node_dofs, turn_length
from snapjump.frame.base import condense_first, condense_last, end_tangents, place_ends
from snapjump.frame.ends import release_first_node, release_last_node
from snapjump.frame.immovable import immovable
from snapjump.number.functions import cos, sin


@immovable
class FixedFrame(NamedTuple):
    """Half the clear span, and the height of both mounts (in L)."""

    half_span: float
    mount_height: float


@end_tangents.member(FixedFrame)
def _end_tangents(
    frame: FixedFrame, mesh: Any, load: Any, angles: Any, state: Any, turning: Any
) -> Any:
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
def _place_ends(frame: FixedFrame, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
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
    frame: FixedFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    release_first_node(node_dofs(discretization), system.residual, system.band)


@condense_last.member(FixedFrame)
def _condense_last(
    frame: FixedFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    dofs = node_dofs(discretization)
    release_last_node(dofs, system.residual, system.band, state.shape[0] // dofs - 1)
