"""The memory of a march: every array the time loop touches, allocated once before it starts."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.number.memory import aligned_zeros

CORNERS = 4


class System(NamedTuple):
    """The linear system of a Newton iteration.

    residual (D + pad), band (B + pad, 6), border (B + pad, 3), square (3, 3): D coordinates, the
    frame's first, of which B belong to nodes; the padding spares the solver its edge cases.
    """

    residual: Any
    band: Any
    border: Any
    square: Any


class Work(NamedTuple):
    """State and memory of a march, for one robot or for a set of lanes.

    state: current Newton iterate (D); start: state at the step's beginning (D); origin, drift:
    the stage's position and velocity before its own share (D); change: last Newton correction
    (D); velocity, acceleration: of every stage, the first being the step's beginning (S, D);
    slip: sliding velocities at the last iterate, corners first (4 + nodes); clock: scalars by
    lane (see :mod:`snapjump.engine.clock`); numbers: of the model (P).
    """

    state: Any
    start: Any
    origin: Any
    drift: Any
    change: Any
    velocity: Any
    acceleration: Any
    slip: Any
    clock: Any
    numbers: Any
    system: System


def make_work(
    nodes: int, frame_dofs: int, stages: int, clocks: int, numbers: int, lanes: int
) -> Work:
    """Zeroed memory of shape (..., lanes)."""
    beam = 2 * nodes
    size = frame_dofs + beam

    def zeros(*shape: int) -> NDArray[np.float64]:
        return aligned_zeros((*shape, lanes))

    pad = HALF_BANDWIDTH
    system = System(
        zeros(size + pad), zeros(beam + pad, pad + 1), zeros(beam + pad, 3), zeros(3, 3)
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
        clock=zeros(clocks),
        numbers=zeros(numbers),
        system=system,
    )
