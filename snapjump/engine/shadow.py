"""A robot's shadow: its march again in duals, which carry derivatives by four parameters."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.work import System, Work
from snapjump.number.array import uncounted
from snapjump.number.dispatch import routine
from snapjump.number.dual import DOUBLES, PARAMETERS, view_duals
from snapjump.number.memory import aligned_zeros
from snapjump.number.nowhere import nowhere

Array = NDArray[np.float64]


class Shadow(NamedTuple):
    """Memory of W shadows; the last axis of a dual array holds one dual (8 doubles).

    numbers (W, P, 8): of the model; state, start, origin, drift (W, D, 8); velocity, acceleration
    (W, S, D, 8): as in :class:`~snapjump.engine.work.Work`; sliding_velocity (W, C, 8); residual
    (W, B, 8), frame_residual (W, F, 8): of the frame's F and the nodes' B coordinates; weights (S):
    of the stage at hand; slopes (W, B + 10, 4), padded by five rows of zeros on either side, and
    frame_slopes (W, F, 4): derivatives of the residual, then of the correction.
    """

    numbers: Any
    state: Any
    start: Any
    origin: Any
    drift: Any
    velocity: Any
    acceleration: Any
    sliding_velocity: Any
    residual: Any
    frame_residual: Any
    weights: Any
    slopes: Any
    frame_slopes: Any


def make_shadow(memory: Work) -> Shadow:
    """Zeroed shadows for every lane of a march's memory."""
    stages, size, lanes = memory.velocity.shape
    nodes = memory.system.residual.shape[0]
    frame = memory.system.frame_residual.shape[0]

    def duals(*shape: int) -> Array:
        return aligned_zeros((lanes, *shape, DOUBLES))

    return Shadow(
        numbers=duals(memory.numbers.shape[0]),
        state=duals(size),
        start=duals(size),
        origin=duals(size),
        drift=duals(size),
        velocity=duals(stages, size),
        acceleration=duals(stages, size),
        sliding_velocity=duals(memory.sliding_velocity.shape[0]),
        residual=duals(nodes),
        frame_residual=duals(frame),
        weights=np.zeros(stages),
        slopes=aligned_zeros((lanes, nodes + 2 * HALF_BANDWIDTH, PARAMETERS)),
        frame_slopes=aligned_zeros((lanes, frame, PARAMETERS)),
    )


@routine
def view_shadow(shadow: Any, lane: Any, mesh: Any) -> Work:
    """One lane's shadow as the memory of a march whose matrix is not wanted."""
    residual = view_duals(shadow.residual[lane])
    frame_residual = view_duals(shadow.frame_residual[lane])
    forgotten = nowhere()
    system = System(
        residual,
        forgotten,
        forgotten,
        residual,
        forgotten,
        forgotten,
        frame_residual,
        forgotten,
        forgotten,
        frame_residual,
        forgotten,
        forgotten,
        forgotten,
        forgotten,
        forgotten,
    )
    sliding_velocity = view_duals(shadow.sliding_velocity[lane])
    return Work(
        view_duals(shadow.state[lane]),
        view_duals(shadow.start[lane]),
        view_duals(shadow.origin[lane]),
        view_duals(shadow.drift[lane]),
        forgotten,
        view_duals(shadow.velocity[lane]),
        view_duals(shadow.acceleration[lane]),
        sliding_velocity,
        forgotten,
        forgotten,
        view_duals(shadow.numbers[lane]),
        uncounted(shadow.weights),
        uncounted(mesh),
        system,
    )
