"""Kernels in plain Python: their memory as ordinary arrays, real or complex, and derivatives."""

from collections.abc import Callable
from typing import Any

import numpy as np

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.assemble import Motion, assemble
from snapjump.engine.view import PlainWork
from snapjump.engine.work import Sizes, make_memory
from snapjump.frame.base import NO_MESH

STEP = 1e-30


def complex_step(function: Callable[[Any], Any], x: Any) -> Any:
    """Jacobian of an analytic function (gradient of a scalar one), exact to rounding."""
    columns = []
    for i in range(len(x)):
        moved = np.array(x, dtype=complex)
        moved[i] += 1j * STEP
        columns.append(np.imag(function(moved)) / STEP)
    return np.array(columns).T


def sizes(
    nodes: int, dofs: int, per_node: int = 2, lanes: int = 1, chain: int = 0, stages: int = 2
) -> Sizes:
    """Of a beam's nodes and a frame's coordinates, ``chain`` of an elastic frame."""
    points = nodes + max(4, chain // 2)
    padded = (per_node * nodes + 10, max(dofs, 3) + 10, chain + 10)
    width = 6 if chain else 3
    return Sizes(lanes, dofs + per_node * nodes, stages, points, 1, width, *padded)


def plain_work(
    nodes: int,
    dofs: int,
    stages: int = 2,
    dtype: type = float,
    per_node: int = 2,
    mesh: Any = NO_MESH,
) -> PlainWork:
    """The memory of one robot without the axis of lanes."""
    chain = dofs if len(mesh) else 0
    extents = sizes(nodes, dofs, per_node, chain=chain, stages=stages)
    return PlainWork(make_memory(extents, mesh, lambda shape: np.zeros(shape, dtype)))


def assembled(
    model: Any, motion: Motion, masses: Any, state: Any, mesh: Any = NO_MESH, **arrays: Any
) -> tuple[Any, PlainWork]:
    """The figures and the memory after an assembly; ``arrays`` are further parts of the memory."""
    state = np.asarray(state)
    kind = {"dtype": state.dtype.type, "per_node": model.discretization.node_dofs(), "mesh": mesh}
    work = plain_work(len(masses), model.frame.dofs(mesh), **kind)
    work.state[:] = state
    for name, values in arrays.items():
        getattr(work, name)[...] = values
    return assemble(model, motion, masses, work), work


def residual_of(work: PlainWork, dofs: int) -> Any:
    """Residual of the frame and of all nodes, slaves (zero there) included."""
    return np.concatenate([work.frame_residual[:dofs], work.residual])


def whole(band: Any) -> Any:
    """The symmetric matrix of a lower band (size, width); what lies below its last row is none."""
    size, width = band.shape
    lower = sum(np.diag(band[: size - k, k], -k) for k in range(width))
    return lower + np.tril(lower, -1).T


def dense(work: PlainWork, dofs: int) -> Any:
    """The whole tangent matrix of frame and nodes."""
    corner, border = work.corner_block[:dofs, :dofs], work.border[:, :dofs]
    return np.block([[corner, border.T], [border, whole(work.band[:, : HALF_BANDWIDTH + 1])]])
