"""An elastic frame: the paper's open chain of nodes, leg - top - leg, far stiffer than the beam.

The beam's ends hang from one edge of either leg (a mount): they follow its middle, an inset away
from it, and turn with it. All nodes have mass and weight; each can touch the ground.
"""

from typing import Any, NamedTuple

import numpy as np

from snapjump.checks import ParameterError
from snapjump.contact.base import PAPER_ELEMENTS
from snapjump.declare.fields import Need, choice, flag, integer, number
from snapjump.discretization.base import NodeMotion
from snapjump.frame.base import FrameOptions, Mesh, Outline, body_acceleration
from snapjump.frame.parts.elastic_chain import add_chain_forces, chain_dissipation, chain_energy
from snapjump.frame.parts.elastic_mesh import DOFS, LEFT_CORNER, RIGHT_CORNER, node_count, node_mass
from snapjump.frame.parts.elastic_mounts import ElasticMounts, clear_mounts
from snapjump.frame.parts.elastic_solve import solve_chain
from snapjump.frame.rigid import RigidFrame
from snapjump.number.functions import absolute, maximum

MOUNTS = ("exact", "edge_middle")

CONTACTS = ("nodes", "corners")

LOW_SHARE = 0.15  # of a leg's elements, below an exact mount


class ElasticFrame(FrameOptions):
    """The paper's open chain, leg - top - leg, of nodes that are far stiffer than the beam.

    ``bending_ratio``, ``stretching_ratio``: its EI and EA over the beam's (the released program:
    1000 and 1). ``mount``: the clamps' height as it is (the leg's mesh follows it), or rounded to
    the middle of an edge of an even mesh. ``inset_m``: how far the beam's ends are from the legs.
    ``contact``: all nodes can touch the ground, or only feet and top corners, as of a rigid frame.
    ``beam_on_top``: the beam's mass comes on top of the robot's, which is all the frame's.
    ``right_follow``: share of its leg's bending that the right clamp turns with; below 1 it has no
    energy and serves comparisons with the released program only (its data: about 0.5).
    """

    explicit = False
    differentiable = False
    needs = (
        Need(
            "discretization",
            "nodes_without_angles",
            "whose mounts have no angle for nodes that turn",
        ),
    )

    bending_ratio: float = number(
        1000.0, above=0.0, doc="EI over the beam's", symbol="EI_f/EI", plan=(1e2, 1e4)
    )
    stretching_ratio: float = number(
        1000.0, above=0.0, doc="EA over the beam's", symbol="EA_f/EA", plan=(1e2, 1e4)
    )
    leg_elements: int = integer(33, least=3, most=10_000)
    top_elements: int = integer(56, least=2, most=10_000)
    mount: str = choice("exact", MOUNTS)
    inset_m: float = number(
        0.0,
        least=0.0,
        unit="m",
        doc="from the beam's ends to the legs",
        symbol="i",
        plan=(0.0, 5e-4),
    )
    contact: str = choice("nodes", CONTACTS)
    beam_on_top: bool = flag(False)
    right_follow: float = number(
        1.0,
        least=0.0,
        most=1.0,
        doc="share of its leg's bending that the right clamp turns with",
        symbol="r",
        plan=(0.0, 1.0),
    )

    @ElasticMounts.member
    class Body(NamedTuple):
        """Half the width; heights of mounts, feet and top above the feet (in L); mass of the
        frame (rho A L) and what of it bounces with a foot; lengths of an edge below, at and above
        a mount, and of the top (L); mass per length (rho A) and clamped at either mount; bending
        stiffness (EI) and stretching stiffness (EI/L^2); distance of the beam's ends from the
        legs (L); weights of contact at a node and, per length, at what belongs to it (1/L); share
        of its leg's bending that the right clamp turns with."""

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

        def add_inertia(self, model: Any, motion: Any, work: Any) -> Any:
            mesh = work.mesh
            state = work.state
            residual = work.frame_residual
            band = work.frame_band
            rate = motion.rate_factor
            drag = model.damping.drag()
            tug, rise = body_acceleration(model, work)
            largest = 0.0 * rate
            clear_mounts(work, largest)
            for node in range(node_count(mesh)):
                i = 2 * node
                mass = node_mass(self, mesh, node)
                vx = (state[i] - work.position_predictor[i]) * rate
                vy = (state[i + 1] - work.position_predictor[i + 1]) * rate
                ax = (vx - work.velocity_predictor[i]) * motion.inertia_rate
                ay = (vy - work.velocity_predictor[i + 1]) * motion.inertia_rate
                residual[i] = mass * (ax + drag * vx - tug)
                residual[i + 1] = mass * (ay + drag * vy - rise)
                band[i, 0] = mass * (motion.inertia_rate + drag) * rate
                band[i + 1, 0] = mass * (motion.inertia_rate + drag) * rate
                largest = maximum(largest, mass * (absolute(ax) + absolute(ay) - rise))
            return largest

        def add_elasticity(self, model: Any, motion: Any, work: Any) -> Any:
            mesh = work.mesh
            state = work.state
            residual = work.frame_residual
            band = work.frame_band
            # Statics leaves x undetermined: a spring that ends up without force holds the top's
            # middle.
            middle = (mesh[LEFT_CORNER] + mesh[RIGHT_CORNER]) // 2
            place = (middle - mesh[LEFT_CORNER]) * self.top_length - self.half_span
            residual[2 * middle] += motion.anchor * (state[2 * middle] - place)
            band[2 * middle, 0] += motion.anchor
            nodes = NodeMotion(state, work.position_predictor, motion.rate_factor)
            return add_chain_forces(self, mesh, model.damping, nodes, residual, band)

        def solve(self, work: Any, done: Any) -> Any:
            return solve_chain(work, done)

        def energy(self, mesh: Any, state: Any) -> Any:
            return chain_energy(self, mesh, state)

        def dissipation(self, damping: Any, mesh: Any, state: Any, velocity: Any) -> Any:
            return chain_dissipation(self, damping, mesh, state, velocity)

    def elements_below(self, mount_share: float) -> int:
        """Elements of a leg below its mount, which is at a share of the leg's height."""
        share = LOW_SHARE if self.mount == "exact" else mount_share - 0.5 / self.leg_elements
        return min(max(1, round(share * self.leg_elements)), self.leg_elements - 2)

    def mesh(self, body: Body) -> Mesh:
        """Coordinates, the left mount's edge, and the nodes of the top's two corners."""
        nodes = 2 * self.leg_elements + self.top_elements + 1
        corners = (self.leg_elements, self.leg_elements + self.top_elements)
        below = self.elements_below(body.mount_y / body.top_y)
        return np.array([2 * nodes, below, *corners], dtype=np.int64)

    def body(self, outline: Outline) -> Body:
        """The dimensionless frame, of the rigid one's mass and outline.

        What bounces with a foot is taken from the rigid frame: its legs are far stiffer than
        contact. Raises ParameterError for a mount less than half an edge from a leg's ends.
        """
        height, width, end = outline.height, outline.width, outline.end
        leg_edge = height / self.leg_elements
        below = self.elements_below(outline.mount / height)
        above = self.leg_elements - 1 - below
        mount = outline.mount
        if self.mount == "edge_middle":
            mount = (below + 0.5) * leg_edge
        low, high = mount - 0.5 * leg_edge, height - mount - 0.5 * leg_edge
        if low <= 0.0 or high <= 0.0:
            raise ParameterError(
                "robot.mount_height",
                outline.mount * outline.length_m,
                f"between half an edge of frame=elastic, {0.5 * leg_edge * outline.length_m:.4g} "
                "m, and robot.frame_height_m less that",
            )
        rigid = RigidFrame().body(outline._replace(mount=mount))
        mass = rigid.mass + float(self.beam_on_top)
        nodes = self.contact == "nodes"
        return self.Body(
            half_span=0.5 * width,
            mount_y=mount,
            foot_y=0.0,
            top_y=height,
            mass=mass,
            bouncing_mass=1.0
            / (1.0 / rigid.mass + rigid.half_span * rigid.half_span / rigid.inertia),
            low_length=low / below,
            mount_length=leg_edge,
            high_length=high / above,
            top_length=width / self.top_elements,
            density=(mass - 2.0 * end) / (2.0 * height + width),
            clamped_mass=end,
            bending=self.bending_ratio,
            stretching=self.stretching_ratio * outline.stretching,
            inset=self.inset_m / outline.length_m,
            node_weight=float(nodes and not outline.per_length),
            length_weight=float(PAPER_ELEMENTS if nodes and outline.per_length else 0),
            right_follow=self.right_follow,
        )
