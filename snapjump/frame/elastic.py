"""An elastic frame: the paper's open chain of nodes, leg - top - leg, far stiffer than the beam.

The beam's ends hang from one edge of either leg (a mount): they follow its middle, an inset away
from it, and turn with it. All nodes have mass and weight; each can touch the ground.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.frame.base import FrameForces
from snapjump.frame.elastic_chain import add_chain_forces, chain_dissipation, chain_energy
from snapjump.frame.elastic_mesh import (
    DOFS,
    LEFT_CORNER,
    RIGHT_CORNER,
    is_corner,
    node_count,
    node_mass,
    weight_at,
)
from snapjump.frame.elastic_mounts import ElasticMounts, clear_mounts
from snapjump.frame.elastic_solve import solve_chain
from snapjump.frame.point_contact import add_point_contact
from snapjump.number.functions import absolute, any_true, maximum, minimum, where


@ElasticMounts.member
class ElasticFrame(NamedTuple):
    """Half the width; heights of mounts, feet and top above the feet (in L); mass of the frame
    (rho A L) and what of it bounces with a foot; lengths of an edge below, at and above a mount,
    and of the top (L); mass per length (rho A) and clamped at either mount; bending stiffness
    (EI) and stretching stiffness (EI/L^2); distance of the beam's ends from the legs (L); weights
    of contact at a node and, per length, at what belongs to it (1/L); share of its
    leg's bending that the right clamp turns with."""

    half_span: float
    mount_y: float
    foot_y: float
    top_y: float
    mass: float
    bouncing_mass: float
    low_length: float
    mount_length: float
    high_length: float
    top_length: float
    density: float
    clamped_mass: float
    bending: float
    stretching: float
    inset: float
    node_weight: float
    length_weight: float
    right_follow: float

    def dofs(self, mesh: Any) -> Any:
        return mesh[DOFS]

    def border_width(self) -> int:
        return 6

    def add_forces(self, model: Any, motion: Any, work: Any) -> Any:
        mesh = work.mesh
        state = work.state
        residual = work.system.frame_residual
        band = work.system.frame_band[HALF_BANDWIDTH:]
        rate = motion.rate_factor
        drag = model.damping.drag()
        fall = model.load.gravity()
        zero = 0.0 * rate
        clear_mounts(work.system, zero)
        figures = FrameForces(zero, zero + 1.0e30, zero)
        for node in range(node_count(mesh)):
            i = 2 * node
            mass = node_mass(self, mesh, node)
            vx = (state[i] - work.origin[i]) * rate
            vy = (state[i + 1] - work.origin[i + 1]) * rate
            ax = (vx - work.drift[i]) * motion.inertia_rate
            ay = (vy - work.drift[i + 1]) * motion.inertia_rate
            residual[i] = mass * (ax + drag * vx)
            residual[i + 1] = mass * (ay + drag * vy + fall)
            band[i, 0] = mass * (motion.inertia_rate + drag) * rate
            band[i + 1, 0] = mass * (motion.inertia_rate + drag) * rate
            inertial = mass * (absolute(ax) + absolute(ay) + fall)
            figures = FrameForces(
                maximum(figures.largest_force, inertial),
                figures.smallest_gap,
                figures.contact_rate_squared,
            )
            if model.contact.exists():
                weight = weight_at(self, mesh, node, model.ground)
                if any_true(weight > 0.0):
                    figures = add_point_contact(
                        model,
                        motion,
                        work,
                        self.bouncing_mass,
                        weight,
                        i,
                        i,
                        node,
                        residual,
                        band,
                        figures,
                    )
        # Statics leaves x undetermined: a spring that ends up without force holds the top's middle.
        middle = (mesh[LEFT_CORNER] + mesh[RIGHT_CORNER]) // 2
        place = (middle - mesh[LEFT_CORNER]) * self.top_length - self.half_span
        residual[2 * middle] += motion.anchor * (state[2 * middle] - place)
        band[2 * middle, 0] += motion.anchor
        largest = add_chain_forces(
            self, mesh, model.damping, state, work.origin, rate, residual, band
        )
        return FrameForces(
            maximum(figures.largest_force, largest),
            figures.smallest_gap,
            figures.contact_rate_squared,
        )

    def solve(self, mesh: Any, state: Any, system: Any, done: Any) -> Any:
        return solve_chain(mesh, state, system, done)

    def limit_step(self, mesh: Any, state: Any, drop: Any, fraction: Any) -> Any:
        share = 1.0 + 0.0 * state[0]
        light = self.node_weight + self.length_weight <= 0.0
        for node in range(node_count(mesh)):
            if is_corner(mesh, node) or not any_true(light):
                fall = drop[2 * node + 1]
                allowed = (1.0 - fraction) * state[2 * node + 1]
                beyond = fall > allowed
                if any_true(beyond):
                    share = minimum(share, where(beyond, allowed / absolute(fall), 1.0))
        return share

    def energy(self, mesh: Any, state: Any) -> Any:
        return chain_energy(self, mesh, state)

    def dissipation(self, damping: Any, mesh: Any, state: Any, velocity: Any) -> Any:
        return chain_dissipation(self, damping, mesh, state, velocity)
