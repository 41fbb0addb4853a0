"""The memory of a march: every array the time loop touches, allocated once before it starts."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.frame.base import NO_MESH
from snapjump.number.memory import aligned_zeros

CORNERS = 4


class System(NamedTuple):
    """The linear system of a Newton iteration, for B coordinates of nodes and F of the frame.

    residual (B), band (B, 6), border (B, W): of the nodes, two or three coordinates each, W being
    the coordinates of the mounts that they are condensed onto; these are views into the padded
    arrays of B + 10 rows, whose five zero rows before and after spare the solver its edge cases.
    frame_residual (F) and square (W, W): of a rigid frame, or of an elastic one and its mounts.
    The rest is an elastic one's (see :mod:`snapjump.frame.parts.elastic_solve`): mounts (W),
    padded_frame_residual (F + 10), frame_band (F + 10, 6), frame_border (F + 10, 4), levers
    (8, 3), last_residual (4), last_square (4, 4).
    """

    residual: Any
    band: Any
    border: Any
    padded_residual: Any
    padded_band: Any
    padded_border: Any
    frame_residual: Any
    square: Any
    mounts: Any
    padded_frame_residual: Any
    frame_band: Any
    frame_border: Any
    levers: Any
    last_residual: Any
    last_square: Any


class Work(NamedTuple):
    """State and memory of a march, for one robot or for a set of lanes.

    state: current Newton iterate (D); start: state at the step's beginning (D); origin, drift:
    the stage's position and velocity before its own share (D); change: last Newton correction
    (D); velocity, acceleration: of every stage, the first being the step's beginning (S, D);
    sliding_velocity: of every point at the last iterate (C); active_set: 1 where a constraint held
    it at the last iterate (C), see :mod:`snapjump.engine.points`; clock: scalars by lane (see
    :mod:`snapjump.engine.clock`); numbers: of the model (P); weights: of earlier stages (S); mesh:
    of the frame, the same for all lanes (see :mod:`snapjump.frame.base`).
    """

    state: Any
    start: Any
    origin: Any
    drift: Any
    change: Any
    velocity: Any
    acceleration: Any
    sliding_velocity: Any
    active_set: Any
    clock: Any
    numbers: Any
    weights: Any
    mesh: Any
    system: System


def make_work(
    nodes: int,
    frame_dofs: int,
    stages: int,
    clocks: int,
    numbers: int,
    lanes: int,
    node_dofs: int = 2,
    mesh: NDArray[np.int64] = NO_MESH,
    allocate: Callable[[tuple[int, ...]], Any] = aligned_zeros,
) -> Work:
    """Zeroed memory of shape (..., lanes)."""
    chain = frame_dofs if len(mesh) else 0
    width = 6 if chain else 3
    beam = node_dofs * nodes
    size = frame_dofs + beam

    def zeros(*shape: int) -> Any:
        return allocate((*shape, lanes))

    pad = HALF_BANDWIDTH
    residual = zeros(beam + 2 * pad)
    band = zeros(beam + 2 * pad, pad + 1)
    border = zeros(beam + 2 * pad, width)
    frame = zeros(max(frame_dofs, 3) + 2 * pad)
    system = System(
        residual[pad : pad + beam],
        band[pad : pad + beam],
        border[pad : pad + beam],
        residual,
        band,
        border,
        frame[pad : pad + max(frame_dofs, 3)],
        zeros(width, width),
        zeros(width),
        frame,
        zeros(chain + 2 * pad, pad + 1),
        zeros(chain + 2 * pad, 4),
        zeros(8, 3),
        zeros(4),
        zeros(4, 4),
    )
    return Work(
        state=zeros(size),
        start=zeros(size),
        origin=zeros(size),
        drift=zeros(size),
        change=zeros(size),
        velocity=zeros(stages, size),
        acceleration=zeros(stages, size),
        sliding_velocity=zeros(max(CORNERS, chain // 2) + nodes),
        active_set=zeros(max(CORNERS, chain // 2) + nodes),
        clock=zeros(clocks),
        numbers=zeros(numbers),
        weights=zeros(stages),
        mesh=mesh,
        system=system,
    )
