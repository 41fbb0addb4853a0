"""Loose nodes without elements: for scenes in which only contact and friction act."""

from typing import Any, NamedTuple

from snapjump.discretization.base import ChainPowers, Discretization, EndHinge, NodeMotion, no_hinge
from snapjump.number.dispatch import kernel


@Discretization.member
class LooseNodes(NamedTuple):
    """No beam."""

    def has_elements(self) -> bool:
        return False

    def axial_stiffness(self) -> float:
        return 0.0

    def begin_chain(self, damping: Any, nodes: NodeMotion, tangents: Any) -> Any:
        zero = 0.0 * nodes.rate_factor
        return Nothing(zero), no_hinge(zero)

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
        leave_uncoupled(rows.band)
        return chain

    def last_hinge(self, damping: Any, nodes: NodeMotion, tangents: Any) -> EndHinge:
        zero = 0.0 * nodes.rate_factor
        return no_hinge(zero)

    def end_chain(self, chain: Any, rows: Any) -> Any:
        leave_uncoupled(rows.band)

    def internal_energy(self, position: Any, tangents: Any) -> Any:
        return 0.0 * position[0]

    def chain_powers(self, damping: Any, position: Any, velocity: Any, tangents: Any) -> Any:
        zero = 0.0 * position[0]
        return ChainPowers(zero, zero, zero, zero, zero, zero, zero)


class Nothing(NamedTuple):
    """State of a sweep over loose nodes."""

    largest: Any


@kernel
def leave_uncoupled(band: Any) -> None:
    """Write zeros beside the diagonal of a node's columns."""
    for k in range(1, 6):
        band[0, k] = 0.0
        band[1, k] = 0.0
