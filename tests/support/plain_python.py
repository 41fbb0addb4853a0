"""Kernels in plain Python: their memory as ordinary arrays, real or complex, and derivatives."""

from collections.abc import Callable
from typing import Any

import numpy as np

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.assemble import Motion, assemble
from snapjump.engine.view import PlainWork
from snapjump.engine.work import make_memory, sizes_of
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


def plain_work(
    model: Any, nodes: int, stages: int = 2, mesh: Any = NO_MESH, dtype: Any = float
) -> PlainWork:
    """The memory of one robot without the axis of lanes."""
    sizes = sizes_of(model, nodes, stages, mesh=mesh)
    return PlainWork(make_memory(sizes, mesh, lambda shape: np.zeros(shape, dtype)))


def assembled(
    model: Any, motion: Motion, masses: Any, state: Any, mesh: Any = NO_MESH, **arrays: Any
) -> tuple[Any, PlainWork]:
    """The figures and the memory after an assembly; ``arrays`` are further parts of the memory."""
    state = np.asarray(state)
    work = plain_work(model, len(masses), mesh=mesh, dtype=state.dtype)
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
