"""Discrete elastic rods in the plane: the paper's discretization.

Stretching: xi = |e|/l - 1, energy EA xi^2 l / 2. Bending at a node: kappa = 2 tan(phi/2) / d,
energy EI kappa^2 d / 2, with d the node's length. tan(phi/2) = (e1 x e2) / (|e1||e2| + e1.e2) and
grad phi = (-e_y, e_x)/|e|^2 of either edge: no trigonometry.

A clamp is half an end element with a prescribed tangent (hinge length l/2, second order), or, as
in the paper, two fixed nodes (the chain then starts one element further in, with hinge length l:
first order).
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import choice
from snapjump.discretization.base import (
    ChainPowers,
    Discretization,
    DiscretizationOptions,
    NodeMotion,
)
from snapjump.discretization.parts.der_elements import (
    Block,
    Chain,
    axial_force,
    edge_at,
    edge_block,
    edge_force,
    held_edge,
    moving_edge,
    put_columns,
    put_last_node,
    right_clamp,
    side_of,
    stretching_energy,
)
from snapjump.discretization.parts.der_hinges import (
    Coupling,
    end_hinge,
    held_hinge,
    hinge_between,
    hinge_coupling,
    hinge_energy,
    hinge_power,
)
from snapjump.discretization.parts.der_skew import add_skew, begin_skew, end_skew
from snapjump.discretization.parts.edge import half_angle_tangent, make_edge
from snapjump.number.functions import absolute, maximum
from snapjump.robot.robot import Robot

CLAMPS = ("half_element", "two_nodes")


class DiscreteElasticRod(DiscretizationOptions):
    """Discrete elastic rods (the paper): second order with half-element clamps.

    ``elements`` of the whole beam; ``clamp``: half an element with a prescribed tangent, or the
    paper's two fixed nodes (first order), which leave two elements fewer to move.
    """

    nodes_without_angles = True

    clamp: str = choice("half_element", CLAMPS)

    @Discretization.member
    class Beam(NamedTuple):
        """Element length l, EA, hinge length at a clamp, offset of the clamp (EI = L = 1)."""

        element_length: float
        stretching_stiffness: float
        clamp_hinge_length: float
        clamp_offset: float

        def axial_stiffness(self) -> Any:
            return self.stretching_stiffness / self.element_length

        def tells_skew(self) -> bool:
            return True

        def clamp_distance(self) -> Any:
            return self.clamp_offset

        def begin_chain(self, damping: Any, nodes: NodeMotion, tangents: Any) -> Any:
            zero = 0.0 * nodes.rate_factor
            clamp = held_edge(tangents.left_x, tangents.left_y, tangents.left_rate, zero)
            density = 1.0 / self.clamp_hinge_length
            first = side_of(self, damping, edge_at(0, nodes))
            hinge = hinge_between(damping, clamp, first, density, nodes.rate_factor)
            left = end_hinge(hinge, first, hinge.pull.ax, hinge.pull.ay)
            chain = Chain(
                first,
                hinge.moment,
                hinge.stiffness,
                Coupling(zero, zero, zero, zero),
                Block(zero, zero, zero),
                zero,
                zero,
                absolute(hinge.moment),
                side_of(self, damping, edge_at(1, nodes)),
                begin_skew(hinge.pull, zero),
            )
            return chain, left

        def add_node_forces(
            self,
            damping: Any,
            nodes: NodeMotion,
            tangents: Any,
            chain: Any,
            node: Any,
            following: Any,
            rows: Any,
        ) -> Any:
            edge = chain.edge
            after = chain.after
            if following > 0:
                density = 1.0 / self.element_length
                hinge = hinge_between(damping, edge, after, density, nodes.rate_factor)
            else:
                hinge = held_hinge(self, damping, edge, after, tangents, nodes)
            # Its root and quotient take long, and depend on nothing that is being eliminated.
            if following > 1:
                next_but_one = side_of(self, damping, edge_at(node + 2, nodes))
            else:
                next_but_one = right_clamp(tangents, 0.0 * nodes.rate_factor)

            stretching = self.stretching_stiffness / self.element_length
            skew = add_skew(damping, stretching, chain.skew, edge, after, hinge.pull, rows.skew)
            sideways = (chain.moment - hinge.moment) * edge.over
            fx = edge.force * edge.cx - sideways * edge.cy
            fy = edge.force * edge.cy + sideways * edge.cx
            stretching = stretching * damping.stiffening(nodes.rate_factor)
            hinges = chain.stiffness + hinge.stiffness
            own = edge_block(stretching, edge.force, sideways, hinges, edge)
            coupling = hinge_coupling(hinge.stiffness, edge, after)
            put_columns(chain.before, chain.coupling, own, coupling, rows.band)
            rows.residual[0] += chain.force_x - fx
            rows.residual[1] += chain.force_y - fy
            return Chain(
                after,
                hinge.moment,
                hinge.stiffness,
                coupling,
                own,
                fx,
                fy,
                maximum(chain.largest, absolute(fx) + absolute(fy)),
                next_but_one,
                skew,
            )

        def last_hinge(self, damping: Any, nodes: NodeMotion, tangents: Any) -> Any:
            edge = side_of(self, damping, edge_at(nodes.position.shape[0] // 2 - 2, nodes))
            clamp = right_clamp(tangents, 0.0 * nodes.rate_factor)
            hinge = held_hinge(self, damping, edge, clamp, tangents, nodes)
            return end_hinge(hinge, edge, hinge.pull.bx, hinge.pull.by)

        def end_chain(self, chain: Any, rows: Any) -> Any:
            end_skew(chain.skew, rows.skew)
            put_last_node(chain.before, (chain.force_x, chain.force_y), rows.residual, rows.band)

        def internal_energy(self, position: Any, tangents: Any) -> Any:
            elements = position.shape[0] // 2 - 1
            still = NodeMotion(position, position, 0.0)
            ax = tangents.left_x
            ay = tangents.left_y
            hinge_length = self.clamp_hinge_length
            energy = 0.0 * position[0]
            for j in range(elements):
                edge = edge_at(j, still)
                t = half_angle_tangent(ax, ay, edge.cx, edge.cy)
                energy = (
                    energy + stretching_energy(self, edge.length) + hinge_energy(t, hinge_length)
                )
                ax = edge.cx
                ay = edge.cy
                hinge_length = self.element_length
            t = half_angle_tangent(ax, ay, tangents.right_x, tangents.right_y)
            last = hinge_energy(t, self.clamp_hinge_length)
            return energy + (1.0 - tangents.right_free) * last

        def chain_powers(self, damping: Any, position: Any, velocity: Any, tangents: Any) -> Any:
            elements = position.shape[0] // 2 - 1
            stretching = self.stretching_stiffness / self.element_length
            edge = make_edge(tangents.left_x, tangents.left_y, 0.0 * position[0], 0.0 * position[0])
            rate = tangents.left_rate
            hinge_length = self.clamp_hinge_length
            zero = 0.0 * position[0]
            power = zero
            moment = zero
            left = zero
            left_x = zero
            left_y = zero
            force = zero
            for j in range(elements):
                after = moving_edge(j, position, velocity)
                t = half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)
                bending, next_moment = hinge_power(damping, t, after.turn_rate - rate, hinge_length)
                if j == 0:
                    left = next_moment
                if j == 1:
                    left_x, left_y = edge_force(force, moment - next_moment, edge)
                force = axial_force(self, damping, stretching, after)
                elastic = stretching * (after.length - self.element_length)
                power = power + (force - elastic) * after.stretch_rate + bending
                moment = next_moment
                edge = after
                rate = after.turn_rate
                hinge_length = self.element_length
            t = half_angle_tangent(edge.cx, edge.cy, tangents.right_x, tangents.right_y)
            bending, right = hinge_power(
                damping, t, tangents.right_rate - rate, self.clamp_hinge_length
            )
            held = 1.0 - tangents.right_free
            right = held * right + tangents.right_free * tangents.right_moment
            right_x, right_y = edge_force(force, moment - right, edge)
            return ChainPowers(
                power + held * bending, left, right, -left_x, -left_y, right_x, right_y
            )

    @property
    def moving_elements(self) -> int:
        """Elements of the chain between the clamps."""
        return self.elements if self.clamp == "half_element" else self.elements - 2

    @property
    def clamped_mass_bar(self) -> float:
        """Mass of the nodes that move with one clamp (in rho A L)."""
        return (0.5 if self.clamp == "half_element" else 1.5) / self.elements

    def beam(self, robot: Robot) -> Beam:
        """The dimensionless rod."""
        length = 1.0 / self.elements
        half = self.clamp == "half_element"
        return self.Beam(
            element_length=length,
            stretching_stiffness=robot.stretching_stiffness_bar,
            clamp_hinge_length=0.5 * length if half else length,
            clamp_offset=0.0 if half else length,
        )
