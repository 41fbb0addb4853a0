"""A wall on the left, nothing on the right: the cantilever of the verification scene."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
from snapjump.frame.base import Frame
from snapjump.frame.parts.ends import release_first_node
from snapjump.number.trigonometry import cos, sin


@Frame.member
class CantileverFrame(NamedTuple):
    """The left end clamped at the origin."""

    def end_tangents(self, mesh: Any, load: Any, angles: Any, state: Any, rotations: Any) -> Any:
        zero = 0.0 * state[0]
        _, _, moment = load.tip_load()
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

    def place_ends(self, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
        offset = discretization.clamp_distance()
        state[0] = offset * cos(angles.left)
        state[1] = -offset * sin(angles.left)
        if discretization.node_dofs() == 3:
            state[2] = -discretization.rotation_length() * angles.left

    def condense_first(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
        release_first_node(model.discretization.node_dofs(), work)
