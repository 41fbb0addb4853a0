"""A wall on the left, nothing on the right: the cantilever of the verification scene."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents, clamp_offset, node_dofs, turn_length
from snapjump.frame.base import condense_first, condense_last, end_tangents, place_ends
from snapjump.frame.ends import release_first_node
from snapjump.frame.immovable import immovable
from snapjump.load.base import tip_load
from snapjump.number.functions import cos, sin


@immovable
class CantileverFrame(NamedTuple):
    """The left end clamped at the origin."""


@end_tangents.member(CantileverFrame)
def _end_tangents(
    frame: CantileverFrame, mesh: Any, load: Any, angles: Any, state: Any, turning: Any
) -> Any:
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
def _place_ends(
    frame: CantileverFrame, mesh: Any, discretization: Any, angles: Any, state: Any
) -> None:
    offset = clamp_offset(discretization)
    state[0] = offset * cos(angles.left)
    state[1] = -offset * sin(angles.left)
    if node_dofs(discretization) == 3:
        state[2] = -turn_length(discretization) * angles.left


@condense_first.member(CantileverFrame)
def _condense_first(
    frame: CantileverFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    release_first_node(node_dofs(discretization), system.residual, system.band)


@condense_last.member(CantileverFrame)
def _condense_last(
    frame: CantileverFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    pass
