"""The memory of a march: every array the time loop touches, allocated once before it starts."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.number.memory import aligned_zeros

CORNERS = 4


class System(NamedTuple):
    """The linear system of a Newton iteration, for B coordinates of nodes and F of the frame.

    residual (B), band (B, 6), border (B, 3): of the nodes, two or three coordinates each; these
    are views into the padded arrays of B + 10 rows, whose five zero rows before and after spare
    the solver its edge cases.
    frame_residual (F) and square (3, 3): of the frame.
    """

    residual: Any
    band: Any
    border: Any
    padded_residual: Any
    padded_band: Any
    padded_border: Any
    frame_residual: Any
    square: Any


class Work(NamedTuple):
    """State and memory of a march, for one robot or for a set of lanes.

    state: current Newton iterate (D); start: state at the step's beginning (D); origin, drift:
    the stage's position and velocity before its own share (D); change: last Newton correction
    (D); velocity, acceleration: of every stage, the first being the step's beginning (S, D);
    slip: sliding velocities at the last iterate, corners first (4 + nodes); held: 1 where a
    constraint held a point at the last iterate (4 + nodes); clock: scalars by
    lane (see :mod:`snapjump.engine.clock`); numbers: of the model (P); weights: of earlier
    stages (S).
    """

    state: Any
    start: Any
    origin: Any
    drift: Any
    change: Any
    velocity: Any
    acceleration: Any
    slip: Any
    held: Any
    clock: Any
    numbers: Any
    weights: Any
    system: System


def make_work(
    nodes: int,
    frame_dofs: int,
    stages: int,
    clocks: int,
    numbers: int,
    lanes: int,
    node_dofs: int = 2,
) -> Work:
    """Zeroed memory of shape (..., lanes)."""
    beam = node_dofs * nodes
    size = frame_dofs + beam

    def zeros(*shape: int) -> NDArray[np.float64]:
        return aligned_zeros((*shape, lanes))

    pad = HALF_BANDWIDTH
    residual = zeros(beam + 2 * pad)
    band = zeros(beam + 2 * pad, pad + 1)
    border = zeros(beam + 2 * pad, 3)
    system = System(
        residual[pad : pad + beam],
        band[pad : pad + beam],
        border[pad : pad + beam],
        residual,
        band,
        border,
        zeros(3),
        zeros(3, 3),
    )
    return Work(
        state=zeros(size),
        start=zeros(size),
        origin=zeros(size),
        drift=zeros(size),
        change=zeros(size),
        velocity=zeros(stages, size),
        acceleration=zeros(stages, size),
        slip=zeros(CORNERS + nodes),
        held=zeros(CORNERS + nodes),
        clock=zeros(clocks),
        numbers=zeros(numbers),
        weights=zeros(stages),
        system=system,
    )
