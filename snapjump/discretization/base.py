"""Discretizations of the beam: the contract that every one fulfils.

A discretization is a ``NamedTuple`` of dimensionless numbers (EI = rho A = L = 1). The beam is a
chain of N elements and N + 1 nodes with two or three coordinates each, all of them in the state
vector (x_0, y_0, x_1, y_1, ...). The third one, where nodes turn, is the rotation theta of the
cross-section times an element's length l: a length as well, so that norms, tolerances and
eigenvalues mean the same with it and without. Nodes at clamps are slaves of the frame, which
condenses their rows and columns onto its own coordinates (:mod:`snapjump.frame`).

The tangent matrix is symmetric and stored as a lower band, column by column: ``band[j, k]`` is
the entry of row j + k and column j, for k = 0 ... HALF_BANDWIDTH.
"""

from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.declare.fields import Part, integer
from snapjump.number.dispatch import kernel
from snapjump.number.methods import Contract, required
from snapjump.robot.robot import Robot

HALF_BANDWIDTH = 5
# What the band lacks of a row j, its ``skew``: entry k of the row j + k and the column j, and from
# RIGHT on, entry HALF_BANDWIDTH + k of the row j and the column j + k.
RIGHT = HALF_BANDWIDTH + 1
SKEW = 2 * HALF_BANDWIDTH + 1
NODES_COUPLED = 2  # a node couples to that many on either side, to one if nodes turn
# Rotary inertia of a node over its mass, in the unit of its third coordinate: two rigid half
# elements of l/2 turn about the node with 2 l^3/24, in theta, and a free end has half of both.
ROTARY_INERTIA = 1.0 / 12.0


class NodeMotion(NamedTuple):
    """Positions of a chain's nodes within a stage of an integrator, of which velocities are
    ``(position - predictor) rate_factor``."""

    position: Any
    predictor: Any
    rate_factor: Any


class EndTangents(NamedTuple):
    """Prescribed unit tangents at both ends and the rates of their directions (rad/T).

    Where ``right_free`` is 1 the last tangent is free and only feels ``right_moment``.
    """

    left_x: Any
    left_y: Any
    left_rate: Any
    right_x: Any
    right_y: Any
    right_rate: Any
    right_free: Any
    right_moment: Any


class EndHinge(NamedTuple):
    """A hinge between a prescribed tangent and an end edge.

    ``moment`` is dE/dphi, ``stiffness`` its derivative, (``slope_x``, ``slope_y``) the gradient of
    the edge's direction with respect to the edge vector (rad/L), and what all this lacks, for
    derivatives alone: (``rate_x``, ``rate_y``) of d(moment)/d(edge vector) (EI/L^2), ``turned`` of
    d(moment)/dphi.
    """

    moment: Any
    stiffness: Any
    slope_x: Any
    slope_y: Any
    rate_x: Any
    rate_y: Any
    turned: Any


@kernel
def no_hinge(zero: Any) -> EndHinge:
    """Where a clamp holds the rotation of its node itself."""
    return EndHinge(zero, zero, zero, zero, zero, zero, zero)


class Discretization(Contract):
    """Discretizations of the beam: the contract that every one fulfils."""

    def has_elements(self) -> Any:
        """Whether there is a beam at all (False for loose nodes)."""
        return True

    @required
    def axial_stiffness(self) -> Any:
        """EA over an element's length (EI/L^3), the largest stiffness of all: so many times the
        last bit of a coordinate is what rounding leaves of a residual. 0 for loose nodes."""

    def node_dofs(self) -> Any:
        """Coordinates of a node, a constant while compiling: 2 (x, y) or 3 (x, y, l theta)."""
        return 2

    def tells_skew(self) -> Any:
        """Whether rows are told all that the symmetric band lacks; a constant, of no number."""
        return False

    def rotation_length(self) -> Any:
        """The length l (in L) of a node's third coordinate l theta; 0 where nodes do not turn."""
        return 0.0

    def clamp_distance(self) -> Any:
        """Distance from the mount, along the clamped tangent, at which the chain begins (in L)."""
        return 0.0

    @required
    def begin_chain(self, damping: Any, nodes: NodeMotion, tangents: Any) -> Any:
        """Begin a sweep along the chain; returns what it carries and the left :class:`EndHinge`
        (empty where nodes turn: a clamp then holds the node's rotation itself).

        The sweep adds gradient and tangent of the elastic (and viscous) energy, node by node.
        What it carries has a number ``largest``: the largest element force so far, a scale for
        residuals.
        """

    @required
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
        """Complete the residual and the band of a node's own ``rows``, not the last one's.

        They hold masses on the band's diagonal and in the residual; the rest is written.
        ``following``: how many elements follow the one that leaves the node, 2 standing for more.
        What the symmetric band lacks is added to ``rows.skew``, for derivatives alone.
        Returns what the sweep carries on.
        """

    @required
    def last_hinge(self, damping: Any, nodes: NodeMotion, tangents: Any) -> Any:
        """The right :class:`EndHinge`."""

    @required
    def end_chain(self, chain: Any, rows: Any) -> Any:
        """Complete the rows of the last node, its own as above."""

    @required
    def internal_energy(self, position: Any, tangents: Any) -> Any:
        """Elastic energy of the chain, stretching and bending (in EI/L)."""

    @required
    def chain_powers(self, damping: Any, position: Any, velocity: Any, tangents: Any) -> Any:
        """The :class:`ChainPowers` of a state, for the energy ledger."""


class ChainPowers(NamedTuple):
    """Power that damping takes out of the chain (EI/(L T)), the moments dE/dphi of both end
    hinges (EI/L), and the gradients of the energy at the first and the last node (EI/L^2)."""

    dissipation: Any
    left_moment: Any
    right_moment: Any
    left_x: Any
    left_y: Any
    right_x: Any
    right_y: Any


class DiscretizationOptions(Part):
    """A discretization and its numbers: by default, every element is between the clamps."""

    group = "discretization"
    nodes_without_angles: ClassVar[bool] = False

    elements: int = integer(120, least=8, most=100_000, doc="of the whole beam")

    @required
    def beam(self, robot: Robot) -> Any:
        """The dimensionless beam: a member of :class:`Discretization`."""

    @property
    def moving_elements(self) -> int:
        """Elements of the chain between the clamps."""
        return self.elements

    @property
    def clamped_mass_bar(self) -> float:
        """Mass of the nodes that move with one clamp (in rho A L)."""
        return 0.5 / self.elements

    def masses(self) -> NDArray[np.float64]:
        """Lumped masses of the chain's nodes, zero where clamped at both ends (in rho A L)."""
        masses = np.full(self.moving_elements + 1, 1.0 / self.elements)
        masses[[0, -1]] = 0.0
        return masses
