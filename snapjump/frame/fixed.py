"""A frame that does not move: both clamps are held in space."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
from snapjump.frame.base import Frame, FrameOptions, Outline
from snapjump.frame.parts.ends import release_first_node, release_last_node
from snapjump.number.trigonometry import cos, sin


class FixedFrame(FrameOptions):
    """Clamps held in space: for scenes without a flight."""

    flies = False
    held = True
    differentiable = False

    @Frame.member
    class Body(NamedTuple):
        """Half the clear span, and the height of both mounts (in L)."""

        half_span: float
        mount_height: float

        def end_tangents(
            self, mesh: Any, load: Any, angles: Any, state: Any, rotations: Any
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

        def place_ends(self, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
            dofs = discretization.node_dofs()
            offset = discretization.clamp_distance()
            last = state.shape[0] - dofs
            half = self.half_span + 0.5 * angles.apart
            state[0] = -half + offset * cos(angles.left)
            state[1] = self.mount_height - offset * sin(angles.left)
            state[last] = half - offset * cos(angles.right)
            state[last + 1] = self.mount_height - offset * sin(angles.right)
            if dofs == 3:
                state[2] = -discretization.rotation_length() * angles.left
                state[last + 2] = discretization.rotation_length() * angles.right

        def condense_first(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
            release_first_node(model.discretization.node_dofs(), work)

        def condense_last(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
            release_last_node(model.discretization.node_dofs(), work)

    def body(self, outline: Outline) -> Body:
        """The dimensionless frame."""
        return self.Body(0.5 * outline.width, outline.mount)
