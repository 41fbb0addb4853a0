"""The sweep along a chain of elements whose nodes turn: the same for all of them.

A node couples to the next one only, and a clamp holds the rotation of its node: there are no
hinges at the ends.
"""

from typing import Any, NamedTuple

from snapjump.damping.none import NoDamping
from snapjump.discretization.base import ChainPowers, Discretization, EndHinge, NodeMotion, no_hinge
from snapjump.discretization.parts.beam_elements import Element, Span, element_of
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, maximum
from snapjump.number.methods import required

UNDAMPED = NoDamping.Law  # a name that kernels can call


class BeamChain(NamedTuple):
    """State of a sweep from left to right: the element before the node, and the largest
    force of an element so far."""

    before: Element
    largest: Any


@kernel
def element_at(beam: Any, damping: Any, j: Any, nodes: NodeMotion) -> Element:
    """Element j of the chain, which moves as its nodes do."""
    i = 3 * j
    position = nodes.position
    predictor = nodes.predictor
    rate_factor = nodes.rate_factor
    over = 1.0 / beam.element_length
    ex = position[i + 3] - position[i]
    ey = position[i + 4] - position[i + 1]
    bend = (position[i + 5] - position[i + 2]) * over
    turn = 0.5 * (position[i + 5] + position[i + 2]) * over
    old_bend = (predictor[i + 5] - predictor[i + 2]) * over
    old_turn = 0.5 * (predictor[i + 5] + predictor[i + 2]) * over
    span = Span(
        ex,
        ey,
        turn,
        (ex - predictor[i + 3] + predictor[i]) * rate_factor,
        (ey - predictor[i + 4] + predictor[i + 1]) * rate_factor,
        (turn - old_turn) * rate_factor,
        rate_factor,
    )
    return element_of(beam, damping, span, bend, (bend - old_bend) * rate_factor, over)


@kernel
def no_element(zero: Any) -> Element:
    """An element without forces, beyond either end of the chain."""
    return Element(zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero)


@kernel
def put_node(before: Element, after: Element, residual: Any, band: Any) -> None:
    """Complete a node's columns and its residual from the elements on either side."""
    residual[0] += before.force_x - after.force_x
    residual[1] += before.force_y - after.force_y
    residual[2] += before.torque + before.moment + (after.torque - after.moment)
    band[0, 0] += before.xx + after.xx
    band[0, 1] = before.xy + after.xy
    band[0, 2] = before.xs - after.xs
    band[0, 3] = -after.xx
    band[0, 4] = -after.xy
    band[0, 5] = -after.xs
    band[1, 0] += before.yy + after.yy
    band[1, 1] = before.ys - after.ys
    band[1, 2] = -after.xy
    band[1, 3] = -after.yy
    band[1, 4] = -after.ys
    band[2, 0] += before.same + after.same
    band[2, 1] = after.xs
    band[2, 2] = after.ys
    band[2, 3] = after.cross


class BeamElements(Discretization):
    """Elements with a rotation at every node: a member declares its strains alone."""

    element_length: Any
    stretching_stiffness: Any

    @required
    def straining_energy(self, ex: Any, ey: Any, turn: Any) -> Any:
        """Energy of one element apart from bending (EI/L)."""

    @required
    def strain_element(self, damping: Any, span: Span) -> Any:
        """The :class:`Straining` of one element; damping adds a viscous share to every strain, and
        to the Hessian what keeps it symmetric."""

    def axial_stiffness(self) -> Any:
        return self.stretching_stiffness / self.element_length

    def node_dofs(self) -> int:
        return 3

    def rotation_length(self) -> Any:
        return self.element_length

    def begin_chain(self, damping: Any, nodes: NodeMotion, tangents: Any) -> Any:
        zero = 0.0 * nodes.rate_factor
        return BeamChain(no_element(zero), zero), no_hinge(zero)

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
        after = element_at(self, damping, node, nodes)
        put_node(chain.before, after, rows.residual, rows.band)
        force = absolute(after.force_x) + absolute(after.force_y)
        return BeamChain(after, maximum(chain.largest, force))

    def last_hinge(self, damping: Any, nodes: NodeMotion, tangents: Any) -> EndHinge:
        zero = 0.0 * nodes.rate_factor
        return no_hinge(zero)

    def end_chain(self, chain: Any, rows: Any) -> None:
        put_node(chain.before, no_element(0.0 * chain.largest), rows.residual, rows.band)

    def internal_energy(self, position: Any, tangents: Any) -> Any:
        over = 1.0 / self.element_length
        energy = 0.0 * position[0]
        for j in range(position.shape[0] // 3 - 1):
            i = 3 * j
            ex = position[i + 3] - position[i]
            ey = position[i + 4] - position[i + 1]
            bend = (position[i + 5] - position[i + 2]) * over
            turn = 0.5 * (position[i + 5] + position[i + 2]) * over
            energy = energy + self.straining_energy(ex, ey, turn) + 0.5 * bend * bend * over
        return energy

    def chain_powers(self, damping: Any, position: Any, velocity: Any, tangents: Any) -> Any:
        zero = 0.0 * position[0]
        over = 1.0 / self.element_length
        last = position.shape[0] // 3 - 2
        power = zero
        first = no_element(zero)
        element = no_element(zero)
        for j in range(last + 1):
            i = 3 * j
            vx = velocity[i + 3] - velocity[i]
            vy = velocity[i + 4] - velocity[i + 1]
            bending = velocity[i + 5] - velocity[i + 2]
            turning = velocity[i + 5] + velocity[i + 2]
            span = Span(
                position[i + 3] - position[i],
                position[i + 4] - position[i + 1],
                0.5 * (position[i + 5] + position[i + 2]) * over,
                vx,
                vy,
                0.5 * turning * over,
                zero,
            )
            bend = (position[i + 5] - position[i + 2]) * over
            element = element_of(self, damping, span, bend, bending * over, over)
            elastic = element_of(self, UNDAMPED(), span, bend, zero, over)
            power = power + (element.force_x - elastic.force_x) * vx
            power = power + (element.force_y - elastic.force_y) * vy
            power = power + (element.torque - elastic.torque) * turning
            power = power + (element.moment - elastic.moment) * bending
            if j == 0:
                first = element
        # dE/dtheta of the end nodes; the left one falls with its hinge's angle.
        length = self.element_length
        return ChainPowers(
            power,
            length * (first.moment - first.torque),
            length * (element.torque + element.moment),
            -first.force_x,
            -first.force_y,
            element.force_x,
            element.force_y,
        )
