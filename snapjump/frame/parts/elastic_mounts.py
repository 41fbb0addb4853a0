"""The elastic frame's mounts: an edge of either leg, which holds an end of the beam.

The beam's end lies an inset away from the edge's middle and turns with it; forces and moments go
back the same way.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH, EndTangents
from snapjump.frame.base import Rotations
from snapjump.frame.parts.elastic_body import ElasticBody
from snapjump.frame.parts.elastic_mesh import DOFS, LEFT_MOUNT, Mount, mount_at, right_mount
from snapjump.frame.parts.ends import Arm, move_first, move_last
from snapjump.number.dispatch import kernel
from snapjump.number.functions import sqrt
from snapjump.number.trigonometry import cos, sin


@kernel
def rotation_of(edge: Any, state: Any, vector: Any) -> Any:
    """Turning of an edge whose nodes move by ``vector``."""
    mount = mount_at(edge, 1.0, state)
    i = 2 * edge
    along_x = vector[i + 2] - vector[i]
    along_y = vector[i + 3] - vector[i + 1]
    return mount.slope_x * along_x + mount.slope_y * along_y


@kernel
def turned(mount: Mount, angle: Any) -> Any:
    """The mount's direction turned by an angle (rad)."""
    c = cos(angle)
    s = sin(angle)
    return mount.cx * c - mount.cy * s, mount.cy * c + mount.cx * s


@kernel
def right_tangent(frame: Any, mesh: Any, angle: Any, state: Any) -> Any:
    """Tangent of the beam at the right clamp, turned by an angle against its mount.

    A clamp that does not follow all of its leg's bending (against the line between the mounts) is
    turned back; the tangent matrix leaves that out, the legs being stiff.
    """
    left = mount_at(mesh[LEFT_MOUNT], 1.0, state)
    right = mount_at(right_mount(mesh), -1.0, state)
    x = right.x - left.x
    y = right.y - left.y
    bending = (x * right.cy - y * right.cx) / sqrt(x * x + y * y)
    return turned(right, angle - (1.0 - frame.right_follow) * bending)


@kernel
def spread_mount(edge: Any, column: Any, work: Any) -> None:
    """Move a mount's force and moment, from ``column`` of ``mount_residual``, to its edge's nodes,
    with the stiffness that the moment has because the edge's direction is not linear."""
    mounts = work.mount_residual
    residual = work.frame_residual
    band = work.padded_frame_band
    mount = mount_at(edge, 1.0, work.state)
    fx = 0.5 * mounts[column]
    fy = 0.5 * mounts[column + 1]
    moment = mounts[column + 2]
    i = 2 * edge
    residual[i] += fx - moment * mount.slope_x
    residual[i + 1] += fy - moment * mount.slope_y
    residual[i + 2] += fx + moment * mount.slope_x
    residual[i + 3] += fy + moment * mount.slope_y
    xx = -2.0 * moment * mount.slope_x * mount.slope_y
    xy = moment * (mount.slope_x * mount.slope_x - mount.slope_y * mount.slope_y)
    j = i + HALF_BANDWIDTH
    for node in range(2):
        band[j + 2 * node, 0] += xx
        band[j + 2 * node, 1] += xy
        band[j + 2 * node + 1, 0] -= xx
    band[j, 2] -= xx
    band[j, 3] -= xy
    band[j + 1, 1] -= xy
    band[j + 1, 2] += xx
    for a in range(3):
        mounts[column + a] = 0.0 * moment


class ElasticMounts(ElasticBody):
    """The elastic frame with its mounts."""

    inset: Any
    right_follow: Any

    def mount_rotations(self, mesh: Any, state: Any, vector: Any) -> Rotations:
        return Rotations(
            rotation_of(mesh[LEFT_MOUNT], state, vector),
            rotation_of(right_mount(mesh), state, vector),
        )

    def end_tangents(
        self, mesh: Any, load: Any, angles: Any, state: Any, rotations: Rotations
    ) -> Any:
        left_x, left_y = turned(mount_at(mesh[LEFT_MOUNT], 1.0, state), -angles.left)
        right_x, right_y = right_tangent(self, mesh, angles.right, state)
        zero = 0.0 * left_x
        return EndTangents(
            left_x,
            left_y,
            rotations.left - angles.left_rate,
            right_x,
            right_y,
            rotations.right + angles.right_rate,
            zero,
            zero,
        )

    def place_ends(self, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
        offset = discretization.clamp_distance()
        left = mount_at(mesh[LEFT_MOUNT], 1.0, state)
        right = mount_at(right_mount(mesh), -1.0, state)
        left_x, left_y = turned(left, -angles.left)
        right_x, right_y = right_tangent(self, mesh, angles.right, state)
        first = mesh[DOFS]
        last = state.shape[0] - discretization.node_dofs()
        state[first] = left.x + self.inset * left.cx + offset * left_x
        state[first + 1] = left.y + self.inset * left.cy + offset * left_y
        state[last] = right.x - self.inset * right.cx - offset * right_x
        state[last + 1] = right.y - self.inset * right.cy - offset * right_y

    def condense_first(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
        offset = model.discretization.clamp_distance()
        edge = work.mesh[LEFT_MOUNT]
        mount = mount_at(edge, 1.0, work.state)
        arm = Arm(
            self.inset * mount.cx + offset * tangents.left_x,
            self.inset * mount.cy + offset * tangents.left_y,
        )
        move_first(model.discretization, hinge, arm, work.mount_residual, work)
        spread_mount(edge, 0, work)

    def condense_last(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
        offset = model.discretization.clamp_distance()
        edge = right_mount(work.mesh)
        mount = mount_at(edge, -1.0, work.state)
        arm = Arm(
            -self.inset * mount.cx - offset * tangents.right_x,
            -self.inset * mount.cy - offset * tangents.right_y,
        )
        move_last(model.discretization, hinge, arm, work.mount_residual, work, 3)
        spread_mount(edge, 3, work)


@kernel
def clear_mounts(work: Any, zero: Any) -> None:
    """Zero the mounts' matrix and right-hand side."""
    for k in range(6):
        work.mount_residual[k] = zero
        for m in range(6):
            work.corner_block[k, m] = zero
