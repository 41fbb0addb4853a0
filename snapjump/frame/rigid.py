"""A rigid frame: three coordinates (x, y, theta) of its centre of mass, contact at four corners.

The clamped end nodes of the beam belong to it, so that its mass matrix is diagonal.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
from snapjump.frame.base import Frame, FrameBox, Outline, Rotations, body_acceleration
from snapjump.frame.parts.ends import move_first, move_last
from snapjump.frame.parts.frame_mass import FrameMass
from snapjump.frame.parts.point_mass import rotation_of
from snapjump.frame.parts.rigid_arms import corner_arm, first_arm, last_arm
from snapjump.linear_solver import banded
from snapjump.linear_solver.contact_rows import CornerRows
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, maximum, where
from snapjump.number.trigonometry import cos, sin

LIFTED = 0.05  # of the anchor's stiffness, against rise and turn


class RigidFrame(FrameMass):
    """A rigid body of three coordinates that carries both clamps and can touch the ground.

    Its own mass is the robot's less the beam's and what is at the clamps. Its centre and its moment
    of inertia about that are, unless given, those of a mass evenly along leg, top, leg (the
    paper's).
    """

    takes_arrays = True

    @Frame.member
    class Body(NamedTuple):
        """Half the width; heights of mounts, feet and top against the centre of mass (in L); mass
        and moment of inertia (in rho A L and rho A L^3); how far the centre is right of the middle,
        and where it rests, for the robot's to be at 0 (in L)."""

        half_span: float
        mount_y: float
        foot_y: float
        top_y: float
        mass: float
        inertia: float
        offset: float
        rest_x: float

        def dofs(self, mesh: Any) -> int:
            return 3

        def border_width(self) -> int:
            return 3

        def mount_rotations(self, mesh: Any, state: Any, vector: Any) -> Rotations:
            return Rotations(vector[2], vector[2])

        def end_tangents(
            self, mesh: Any, load: Any, angles: Any, state: Any, rotations: Rotations
        ) -> Any:
            left = state[2] - angles.left
            right = state[2] + angles.right
            return EndTangents(
                cos(left),
                sin(left),
                rotations.left - angles.left_rate,
                cos(right),
                sin(right),
                rotations.right + angles.right_rate,
                0.0 * left,
                0.0 * left,
            )

        def place_ends(self, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
            still = Rotations(0.0 * state[2], 0.0 * state[2])
            tangents = self.end_tangents(mesh, 0.0, angles, state, still)
            dofs = discretization.node_dofs()
            offset = discretization.clamp_distance()
            left = first_arm(self, offset, tangents, state[2])
            right = last_arm(self, offset, tangents, state[2])
            last = state.shape[0] - dofs
            state[3] = state[0] + left.x
            state[4] = state[1] + left.y
            state[last] = state[0] + right.x
            state[last + 1] = state[1] + right.y
            if dofs == 3:
                state[5] = discretization.rotation_length() * (state[2] - angles.left)
                state[last + 2] = discretization.rotation_length() * (state[2] + angles.right)

        def condense_first(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
            offset = model.discretization.clamp_distance()
            arm = first_arm(self, offset, tangents, work.state[2])
            move_first(model.discretization, hinge, arm, work.frame_residual, work)

        def condense_last(self, model: Any, work: Any, tangents: Any, hinge: Any) -> None:
            offset = model.discretization.clamp_distance()
            arm = last_arm(self, offset, tangents, work.state[2])
            move_last(model.discretization, hinge, arm, work.frame_residual, work, 0)

        def add_inertia(self, model: Any, motion: Any, work: Any) -> Any:
            state = work.state
            residual = work.frame_residual
            square = work.corner_block
            rate = motion.rate_factor
            drag = model.damping.drag()
            largest = 0.0 * rate
            clear(residual, square, largest)
            for k in range(3):
                mass = self.inertia if k == 2 else self.mass
                velocity = (state[k] - work.position_predictor[k]) * rate
                inertial = mass * (velocity - work.velocity_predictor[k]) * motion.inertia_rate
                residual[k] += inertial + mass * drag * velocity
                square[k, k] += mass * (motion.inertia_rate + drag) * rate
                largest = maximum(largest, absolute(inertial))
            along, across = body_acceleration(model, work)
            weight = -self.mass * across
            residual[0] -= self.mass * along
            residual[1] += weight
            # Statics leaves x undetermined: a spring that ends up without force holds it.
            residual[0] += motion.anchor * (state[0] - self.rest_x)
            square[0, 0] += motion.anchor
            # Feet that an iterate lifts off the ground have no stiffness: this lets the weight
            # bring them back, and leaves the equilibrium where it is.
            square[1, 1] += LIFTED * motion.anchor
            square[2, 2] += LIFTED * motion.anchor
            return maximum(largest, 0.0 * rate + weight)

        def stage_point(self, point: Any, work: Any, rate: Any) -> Any:
            state = work.state
            origin = work.position_predictor
            rx, ry = corner_arm(self, point, cos(state[2]), sin(state[2]))
            turn = state[2] - origin[2]
            vx = (state[0] - origin[0]) * rate - ry * (turn * rate)
            return state[1] + ry, vx, (state[1] - origin[1] + rx * turn) * rate

        def fall(self, mesh: Any, point: Any, state: Any, drop: Any) -> Any:
            rx, ry = corner_arm(self, point, cos(state[2]), sin(state[2]))
            # The second-order term bounds the corner's fall along its arc.
            bound = drop[1] + rx * drop[2] + 0.5 * absolute(ry) * drop[2] * drop[2]
            return state[1] + ry, bound

        def contact_rows(self, point: Any, work: Any, rate: Any) -> CornerRows:
            turn = work.state[2]
            rx, ry = corner_arm(self, point, cos(turn), sin(turn))
            turn_rate = (turn - work.position_predictor[2]) * rate
            return CornerRows(work.frame_residual, work.corner_block, rx, ry, turn_rate)

        def solve(self, work: Any, done: Any) -> Any:
            return banded.solve_frame(work, done)

        def contact_points(self, mesh: Any) -> int:
            return 4

        def contact_point(self, mesh: Any, point: Any, state: Any, velocity: Any) -> Any:
            return self.corner_point(mesh, point, state, velocity)

        def corner_point(self, mesh: Any, corner: Any, state: Any, velocity: Any) -> Any:
            rx, ry = corner_arm(self, corner, cos(state[2]), sin(state[2]))
            vx = velocity[0] - ry * velocity[2]
            return state[0] + rx, state[1] + ry, vx, velocity[1] + rx * velocity[2]

        def point_mass(self, mesh: Any, point: Any, state: Any) -> Any:
            rx, _ = corner_arm(self, point, cos(state[2]), sin(state[2]))
            return 1.0 / (1.0 / self.mass + rx * rx / self.inertia)

        def point_share(self, mesh: Any, point: Any, ground: Any) -> Any:
            return ground.corner_share

        def box(self, mesh: Any, state: Any, velocity: Any) -> FrameBox:
            c = cos(state[2])
            s = sin(state[2])
            return FrameBox(
                state[0] - self.offset * c,
                state[1] - self.offset * s,
                c,
                s,
                velocity[2],
                self.half_span,
                self.mount_y,
                self.foot_y,
                self.top_y,
            )

        def rest(self, mesh: Any, state: Any, gap: Any) -> None:
            state[0] = self.rest_x
            state[1] = gap - self.foot_y
            state[2] = 0.0

        def rest_middle(self) -> Any:
            return self.rest_x - self.offset

        def mass_of(self, mesh: Any, coordinate: Any) -> Any:
            return where(coordinate == 2, self.inertia, self.mass)

        def whole_mass(self, mesh: Any) -> Any:
            return self.mass

        def moments(self, mesh: Any, vector: Any) -> Any:
            return self.mass * vector[0], self.mass * vector[1]

        def rotation(self, mesh: Any, state: Any, velocity: Any, about: Any) -> Any:
            momentum, square = rotation_of(self.mass, state, velocity, 0, about)
            return momentum + self.inertia * velocity[2], square + self.inertia

        def slide(self, mesh: Any, vector: Any, along_x: Any) -> None:
            vector[0] = vector[0] + along_x

    def body(self, outline: Outline) -> Body:
        """The dimensionless frame of an outline, whose numbers may be arrays.

        The clamped end nodes of the beam move with it and belong to it.
        """
        whole, mount = self.with_clamps(outline), outline.mount
        free = 1.0 - 2.0 * outline.end  # of the beam's mass
        return self.Body(
            half_span=0.5 * outline.width,
            mount_y=mount - whole.y,
            foot_y=-whole.y,
            top_y=outline.height - whole.y,
            mass=whole.mass,
            inertia=whole.inertia,
            offset=whole.x,
            rest_x=whole.x * free / (whole.mass + free),
        )


@kernel
def clear(residual: Any, square: Any, zero: Any) -> None:
    """Zero the frame's own block and residual."""
    for k in range(3):
        residual[k] = zero
        for m in range(3):
            square[k, m] = zero
