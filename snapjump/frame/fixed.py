"""A frame that does not move: both clamps are held in space."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
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
def _end_tangents(frame: FixedFrame, mesh: Any, load: Any, angles: Any, state: Any, turning: Any) -> Any:
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
def _place_ends(frame: FixedFrame, mesh: Any, offset: Any, angles: Any, state: Any) -> None:
    last = state.shape[0] - 2
    state[0] = -frame.half_span + offset * cos(angles.left)
    state[1] = frame.mount_height - offset * sin(angles.left)
    state[last] = frame.half_span - offset * cos(angles.right)
    state[last + 1] = frame.mount_height - offset * sin(angles.right)


@condense_first.member(FixedFrame)
def _condense_first(
    frame: FixedFrame, mesh: Any, tangents: Any, offset: Any, hinge: Any, state: Any, system: Any
) -> None:
    release_first_node(system.residual, system.band)


@condense_last.member(FixedFrame)
def _condense_last(
    frame: FixedFrame, mesh: Any, tangents: Any, offset: Any, hinge: Any, state: Any, system: Any
) -> None:
    release_last_node(system.residual, system.band, state.shape[0] // 2 - 1)
