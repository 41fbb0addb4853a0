"""Loose nodes without elements: for scenes in which only contact and friction act."""

from typing import Any, NamedTuple

from snapjump.discretization.base import (
    ChainPowers,
    EndHinge,
    add_node_forces,
    axial_stiffness,
    begin_chain,
    chain_powers,
    clamp_offset,
    end_chain,
    has_elements,
    internal_energy,
    node_dofs,
    turn_length,
)
from snapjump.number.dispatch import kernel


class LooseNodes(NamedTuple):
    """No beam."""


@has_elements.member(LooseNodes)
def _has_elements(discretization: LooseNodes) -> bool:
    return False


@axial_stiffness.member(LooseNodes)
def _axial_stiffness(discretization: LooseNodes) -> float:
    return 0.0


@node_dofs.member(LooseNodes)
def _node_dofs(discretization: LooseNodes) -> int:
    return 2


@turn_length.member(LooseNodes)
def _turn_length(discretization: LooseNodes) -> float:
    return 0.0


@clamp_offset.member(LooseNodes)
def _clamp_offset(discretization: LooseNodes) -> float:
    return 0.0


class Nothing(NamedTuple):
    """What a sweep over loose nodes carries."""

    largest: Any


@kernel
def leave_uncoupled(node: Any, band: Any) -> None:
    """Write zeros beside the diagonal of a node's columns."""
    for k in range(1, 6):
        band[2 * node, k] = 0.0
        band[2 * node + 1, k] = 0.0


@begin_chain.member(LooseNodes)
def _begin_chain(
    discretization: LooseNodes,
    damping: Any,
    position: Any,
    origin: Any,
    rate_factor: Any,
    tangents: Any,
) -> Any:
    zero = 0.0 * rate_factor
    return Nothing(zero), EndHinge(zero, zero, zero, zero)


@add_node_forces.member(LooseNodes)
def _add_node_forces(
    discretization: LooseNodes,
    damping: Any,
    position: Any,
    origin: Any,
    rate_factor: Any,
    tangents: Any,
    chain: Any,
    node: Any,
    residual: Any,
    band: Any,
) -> Any:
    zero = 0.0 * rate_factor
    leave_uncoupled(node, band)
    return chain, EndHinge(zero, zero, zero, zero)


@end_chain.member(LooseNodes)
def _end_chain(discretization: LooseNodes, chain: Any, node: Any, residual: Any, band: Any) -> Any:
    leave_uncoupled(node, band)


@internal_energy.member(LooseNodes)
def _internal_energy(discretization: LooseNodes, position: Any, tangents: Any) -> Any:
    return 0.0 * position[0]


@chain_powers.member(LooseNodes)
def _chain_powers(
    discretization: LooseNodes, damping: Any, position: Any, velocity: Any, tangents: Any
) -> Any:
    zero = 0.0 * position[0]
    return ChainPowers(zero, zero, zero, zero, zero, zero, zero)
