"""The time loop: lanes full of robots, each with its own time, step and stage.

One pass of the loop is one Newton iteration of every lane. Whatever a lane's iteration calls for
next (another one, the next stage, the next step, a repetition, the next robot in the queue)
happens under masks, so that no lane waits for another.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine import outcome
from snapjump.engine.clock import (
    ACTIVE,
    COARSEST,
    ERROR,
    ERROR_SUM,
    FAILURES,
    GAP,
    ITERATIONS,
    LAST_CONTACT,
    REJECTED,
    SMALLEST_GAP,
    SMALLEST_STABLE_STEP,
    STABLE_STEP,
    STAGE,
    STATUS,
    STEP,
    STEPS,
    TIME,
)
from snapjump.engine.explicit import evaluate_forces
from snapjump.engine.model import with_numbers
from snapjump.engine.newton import newton_iteration
from snapjump.engine.outcome import COLUMNS, ROWS_OF_CLOCK
from snapjump.engine.stage import (
    begin_stage,
    commit_step,
    contact_frequency,
    keep_stage,
    reach_end,
    stage_motion,
)
from snapjump.engine.start import follow_branch
from snapjump.engine.status import (
    ITERATION_LIMIT,
    NOT_FINITE,
    RUNNING,
    STEP_UNDERFLOW,
)
from snapjump.engine.view import view_memory, view_work
from snapjump.number.array import uncounted
from snapjump.number.atomic import fetch_add
from snapjump.number.dispatch import released, routine
from snapjump.number.functions import any_true, maximum, minimum, negate, where

MOST_BACKTRACKS = 4.0  # in one stage
STABILITY_MARGIN = 0.9  # of the largest stable step, for what stiffens until the next one


class Queue(NamedTuple):
    """Robots to be simulated and what became of them, R in all.

    numbers (R, P): of each model; state, velocity, acceleration (R, D): at its beginning;
    status (R): 0 to march, else skipped; outcome (R, COLUMNS): see
    :mod:`snapjump.engine.outcome`;
    cursor (2): next robot to find the start of, and to march. Threads share all these. Each has
    its own counts (2): robots under way (-1 before the first pass), passes done; and carried (W):
    which robot each lane carries.
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


class Method(NamedTuple):
    """How a march is stepped and ended: an integrator's scheme, a step control, a termination, and
    the most Newton iterations of a stage and of the whole march."""

    scheme: Any
    stepping: Any
    termination: Any
    most_in_stage: float
    most_in_march: float


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


@released
def find_starts(
    template: Any, masses: Any, memory: Any, queue: Queue, lanes: Any, blocks: int
) -> bool:
    """Follow queued robots' static branches from the guess in ``queue.state`` to their starts.

    At most ``blocks`` times as many robots as there are lanes; True when none is left.
    """
    masses = uncounted(masses)
    store = view_memory(memory)
    width = store.clock.shape[1]
    robots = queue.status.shape[0]
    work = view_work(memory, lanes)
    for _ in range(blocks):
        first = fetch_add(queue.cursor, 0, width)
        if first >= robots:
            return True
        for lane in range(width):
            robot = min(first + lane, robots - 1)
            load_robot(store, lane, queue, robot, 1.0)
        model = with_numbers(template, work.numbers)
        work.clock[STATUS] = follow_branch(model, masses, work)
        for lane in range(width):
            robot = first + lane
            if robot < robots:
                queue.status[robot] = store.clock[STATUS, lane]
                for i in range(store.state.shape[0]):
                    queue.state[robot, i] = store.start[i, lane]
                    queue.velocity[robot, i] = store.velocity[0, i, lane]
                    queue.acceleration[robot, i] = store.acceleration[0, i, lane]
    return False


@released
def march(
    template: Any,
    masses: Any,
    method: Method,
    recorder: Any,
    memory: Any,
    queue: Queue,
    lanes: Any,
    passes: int,
) -> bool:
    """Simulate the queue's robots for at most ``passes`` passes; True when none is left.

    All state is in ``memory`` and ``queue``: calling again goes on; threads that share the queue
    each have their own memory, counts and carried. ``lanes`` is a tuple whose
    length is the number of lanes (see :func:`snapjump.number.lane.view_numbers`).
    """
    masses = uncounted(masses)
    method = uncounted(method)
    scheme = method.scheme
    stepping = method.stepping
    store = view_memory(memory)
    width = store.clock.shape[1]
    work = view_work(memory, lanes)
    clock = work.clock
    last_stage = 1.0 * scheme.stage_count()
    step = stepping.first_step()
    if queue.counts[0] < 0:
        queue.counts[0] = 0
        for lane in range(width):
            load_robot(store, lane, queue, 0, step)
            refill(store, lane, queue, recorder, step)
        if queue.counts[0] == 0:
            return True
        model = with_numbers(template, work.numbers)
        begin_stage(model, scheme, masses, work, clock[ACTIVE] >= 0.0)
        recorder.record_start(model, masses, work)

    for _ in range(passes):
        if queue.counts[0] == 0:
            return True
        queue.counts[1] += 1
        model = with_numbers(template, work.numbers)
        active = clock[ACTIVE] > 0.0
        h = clock[STEP]
        motion = stage_motion(scheme, work)
        if scheme.is_explicit():
            correction = evaluate_forces(model, motion, masses, work, active)
        else:
            correction = newton_iteration(
                model,
                motion,
                masses,
                work,
                active,
                stepping.newton_tolerance(),
                method.most_in_stage,
                MOST_BACKTRACKS,
            )
        clock[ITERATIONS] = clock[ITERATIONS] + where(active, 1.0, 0.0)
        converged = correction.converged & active
        failed = correction.failed & active
        restage = failed
        status = 0.0 * h
        if any_true(failed):
            smaller = stepping.step_after_failure(h)
            clock[STEP] = where(failed, smaller, clock[STEP])
            clock[STAGE] = where(failed, 1.0, clock[STAGE])
            clock[FAILURES] = clock[FAILURES] + where(failed, 1.0, 0.0)
            under = failed & (smaller < stepping.smallest_step())
            status = where(under, 1.0 * STEP_UNDERFLOW, status)
        if any_true(converged):
            restage = restage | converged
            error = keep_stage(scheme, work, motion, converged)
            recorder.record_stage(model, masses, motion, scheme, work, converged)
            ended = converged & (clock[STAGE] >= last_stage)
            clock[STAGE] = where(converged, clock[STAGE] + 1.0, clock[STAGE])
            if any_true(ended):
                status = finish_step(model, masses, method, recorder, work, ended, error, status)
        exhausted = active & (clock[ITERATIONS] >= method.most_in_march) & (status == 0.0)
        status = where(exhausted, 1.0 * ITERATION_LIMIT, status)
        leaving = active & (status > 0.0)
        if any_true(leaving):
            clock[STATUS] = where(leaving, status, 0.0)
            for lane in range(width):
                if store.clock[STATUS, lane] > 0.0:
                    recorder.record_end(model, masses, lane, queue.carried[lane])
                    for k in range(COLUMNS):
                        row = ROWS_OF_CLOCK[k]
                        queue.outcome[queue.carried[lane], k] = store.clock[row, lane]
                    queue.counts[0] -= 1
                    refill(store, lane, queue, recorder, step)
                    store.clock[STATUS, lane] = 0.0
            model = with_numbers(template, work.numbers)
        if any_true(restage):
            begin_stage(model, scheme, masses, work, restage)
    return queue.counts[0] == 0


@routine
def finish_step(
    model: Any,
    masses: Any,
    method: Method,
    recorder: Any,
    work: Any,
    ended: Any,
    error: Any,
    status: Any,
) -> Any:
    """Judge the steps that have just ended; returns the status of every lane."""
    scheme = method.scheme
    stepping = method.stepping
    termination = method.termination
    clock = work.clock
    h = clock[STEP]
    error = error / termination.tolerance_factor(model, work)
    rate = contact_frequency(work)
    good = ended & stepping.accepts(error, h, rate)
    if scheme.is_explicit():
        good = good & (h <= clock[STABLE_STEP])
    closed = h < 0.0
    if not scheme.ends_in_a_stage():
        closed = reach_end(model, scheme, masses, work, ended)
        good = good & negate(closed)
    bad = ended & negate(good)
    clock[ERROR] = error
    clock[ERROR_SUM] = clock[ERROR_SUM] + where(good, error, 0.0)
    clock[COARSEST] = where(good, maximum(clock[COARSEST], h * rate), clock[COARSEST])
    clock[STEPS] = clock[STEPS] + where(good, 1.0, 0.0)
    clock[REJECTED] = clock[REJECTED] + where(bad, 1.0, 0.0)
    clock[FAILURES] = where(good, 0.0, clock[FAILURES])
    clock[STAGE] = where(ended, 1.0, clock[STAGE])
    clock[SMALLEST_GAP] = where(good, minimum(clock[SMALLEST_GAP], clock[GAP]), clock[SMALLEST_GAP])
    commit_step(scheme, work, good)
    recorder.record_step(model, masses, scheme, work, good)
    touching = good & (clock[GAP] < model.ground.clearance)
    clock[LAST_CONTACT] = where(touching, clock[TIME], clock[LAST_CONTACT])
    verdict = termination.terminate(model, masses, work, good)
    status = where(good, verdict, status)
    finite = clock[TIME] + error < 1e30
    status = where(ended & negate(finite), 1.0 * NOT_FINITE, status)
    proposed = stepping.next_step(error, scheme.error_power(), h, rate)
    if not scheme.ends_in_a_stage():
        proposed = where(closed, stepping.step_after_failure(h), proposed)
    if scheme.is_explicit():
        stable = clock[STABLE_STEP]
        smallest = minimum(clock[SMALLEST_STABLE_STEP], stable)
        clock[SMALLEST_STABLE_STEP] = where(good, smallest, clock[SMALLEST_STABLE_STEP])
        proposed = minimum(proposed, STABILITY_MARGIN * stable)
    remaining = maximum(
        termination.time_limit(model) - clock[TIME], stepping.smallest_step() + 0.0 * h
    )
    clock[STEP] = where(ended, minimum(proposed, remaining), clock[STEP])
    under = bad & (clock[STEP] < stepping.smallest_step())
    return where(under, 1.0 * STEP_UNDERFLOW, status)
