"""Kernels in plain Python: their memory as ordinary arrays, real or complex, and derivatives."""

from collections.abc import Callable
from typing import Any

import numpy as np

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.assemble import Motion, assemble
from snapjump.engine.clock import ROWS
from snapjump.engine.work import Work, make_work
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
    nodes: int,
    dofs: int,
    stages: int = 2,
    dtype: type = float,
    per_node: int = 2,
    mesh: Any = NO_MESH,
) -> Work:
    """The memory of one robot without the axis of lanes."""
    memory = make_work(nodes, dofs, stages, ROWS, 1, 1, per_node, mesh)

    def plain(array: Any) -> Any:
        return np.zeros(array.shape[:-1], dtype)

    system = memory.system
    padded = [plain(system.padded_residual), plain(system.padded_band), plain(system.padded_border)]
    inner = [array[HALF_BANDWIDTH : HALF_BANDWIDTH + per_node * nodes] for array in padded]
    parts = [plain(array) for array in memory[:-2]]
    others = [plain(array) for array in system[7:]]
    frame = others[2][HALF_BANDWIDTH : HALF_BANDWIDTH + max(dofs, 3)]
    return Work(*parts, mesh, type(system)(*inner, *padded, frame, *others))


def assembled(
    model: Any, motion: Motion, masses: Any, state: Any, mesh: Any = NO_MESH, **arrays: Any
) -> tuple[Any, Work]:
    """The figures and the memory after an assembly; ``arrays`` are further parts of the memory."""
    state = np.asarray(state)
    work = plain_work(
        len(masses),
        model.frame.dofs(mesh),
        dtype=state.dtype.type,
        per_node=model.discretization.node_dofs(),
        mesh=mesh,
    )
    work.state[:] = state
    for name, values in arrays.items():
        getattr(work, name)[...] = values
    return assemble(model, motion, masses, work), work


def residual_of(work: Work, dofs: int) -> Any:
    """Residual of the frame and of all nodes, slaves (zero there) included."""
    return np.concatenate([work.system.frame_residual[:dofs], work.system.residual])


def dense(work: Work, dofs: int) -> Any:
    """The whole tangent matrix of frame and nodes."""
    band, border = work.system.band, work.system.border
    size = len(band)
    full = np.zeros((dofs + size, dofs + size))
    for j in range(size):
        for k in range(min(HALF_BANDWIDTH + 1, size - j)):
            full[dofs + j, dofs + j + k] = full[dofs + j + k, dofs + j] = band[j, k]
    full[:dofs, :dofs] = work.system.square[:dofs, :dofs]
    full[dofs:, :dofs] = border[:, :dofs]
    full[:dofs, dofs:] = border[:, :dofs].T
    return full
