"""Robots that wait for a lane, and what became of them."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine import outcome
from snapjump.engine.clock import ACTIVE, SMALLEST_GAP, SMALLEST_STABLE_STEP, STAGE, STEP
from snapjump.engine.status import RUNNING
from snapjump.number.atomic import fetch_add
from snapjump.number.dispatch import routine


class Queue(NamedTuple):
    """Robots to be simulated and what became of them, R in all.

    numbers (R, P): of each model; state, velocity, acceleration (R, D): at its beginning;
    status (R): 0 to march, else skipped; outcome (R, COLUMNS): see
    :mod:`snapjump.engine.outcome`; cursor (2): next robot to find the start of, and to march.
    Threads share all these. Each has its own counts (2): robots under way (-1 before the first
    pass), passes done; and carried (W): which robot each lane carries.
    """

    numbers: NDArray[np.float64]
    state: NDArray[np.float64]
    velocity: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    status: NDArray[np.float64]
    outcome: NDArray[np.float64]
    cursor: NDArray[np.int64]
    counts: NDArray[np.int64]
    carried: NDArray[np.int64]


@routine
def load_robot(memory: Any, lane: int, queue: Any, robot: int, step: float) -> None:
    """Put a robot of the queue into a lane."""
    for k in range(memory.numbers.shape[0]):
        memory.numbers[k, lane] = queue.numbers[robot, k]
    for i in range(memory.state.shape[0]):
        memory.state[i, lane] = queue.state[robot, i]
        memory.start[i, lane] = queue.state[robot, i]
        # Every slot begins with what a scheme without a past finds in it.
        for slot in range(memory.velocity.shape[0]):
            memory.velocity[slot, i, lane] = queue.velocity[robot, i]
            memory.acceleration[slot, i, lane] = queue.acceleration[robot, i]
    for k in range(memory.clock.shape[0]):
        memory.clock[k, lane] = 0.0
    for k in range(memory.air.shape[0]):
        memory.air[k, lane] = 0.0
    memory.clock[STEP, lane] = step
    memory.clock[STAGE, lane] = 1.0
    memory.clock[SMALLEST_GAP, lane] = 1e30
    memory.clock[SMALLEST_STABLE_STEP, lane] = 1e30
    memory.clock[ACTIVE, lane] = 1.0


@routine
def refill(memory: Any, lane: int, queue: Any, recorder: Any, step: float) -> None:
    """Give a lane the next robot of the queue, or let it idle on the one it has."""
    while True:
        robot = fetch_add(queue.cursor, 1, 1)
        if robot >= queue.status.shape[0]:
            memory.clock[ACTIVE, lane] = 0.0
            queue.carried[lane] = -1
            return
        if queue.status[robot] == RUNNING:
            load_robot(memory, lane, queue, robot, step)
            recorder.record_robot(lane, robot)
            queue.carried[lane] = robot
            queue.counts[0] += 1
            return
        queue.outcome[robot, outcome.STATUS] = queue.status[robot]
