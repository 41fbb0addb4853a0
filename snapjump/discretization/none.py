"""Loose nodes without elements: for scenes in which only contact and friction act."""

from typing import Any, NamedTuple

from snapjump.discretization.base import (
    ChainPowers,
    EndHinge,
    add_internal_forces,
    chain_powers,
    clamp_offset,
    has_elements,
    internal_energy,
)


class LooseNodes(NamedTuple):
    """No beam."""


@has_elements.member(LooseNodes)
def _has_elements(discretization: LooseNodes) -> bool:
    return False


@clamp_offset.member(LooseNodes)
def _clamp_offset(discretization: LooseNodes) -> float:
    return 0.0


@add_internal_forces.member(LooseNodes)
def _add_internal_forces(
    discretization: LooseNodes,
    damping: Any,
    position: Any,
    origin: Any,
    rate_factor: Any,
    tangents: Any,
    residual: Any,
    band: Any,
) -> Any:
    zero = 0.0 * rate_factor
    hinge = EndHinge(zero, zero, zero, zero)
    return hinge, hinge, zero


@internal_energy.member(LooseNodes)
def _internal_energy(discretization: LooseNodes, position: Any, tangents: Any) -> Any:
    return 0.0 * position[0]


@chain_powers.member(LooseNodes)
def _chain_powers(
    discretization: LooseNodes, damping: Any, position: Any, velocity: Any, tangents: Any
) -> Any:
    zero = 0.0 * position[0]
    return ChainPowers(zero, zero, zero, zero, zero, zero, zero)
