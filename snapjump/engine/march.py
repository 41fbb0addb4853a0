"""The time loop: lanes full of robots, each with its own time, step and stage.

One pass of the loop is one Newton iteration of every lane. Whatever a lane's iteration calls for
next (another one, the next stage, the next step, a repetition, the next robot in the queue)
happens under masks, so that no lane waits for another.
"""

from typing import Any

from snapjump.engine.clock import ACTIVE, FAILURES, ITERATIONS, STAGE, STATUS, STEP
from snapjump.engine.explicit import evaluate_forces
from snapjump.engine.model import with_numbers
from snapjump.engine.newton import StageLimits, newton_iteration
from snapjump.engine.outcome import COLUMNS, ROWS_OF_CLOCK
from snapjump.engine.queue import Queue, load_robot, refill
from snapjump.engine.stage import (
    Course,
    Ended,
    begin_stage,
    commit_step,
    estimate_error,
    keep_stage,
    move_on,
    rates_of,
    stage_motion,
)
from snapjump.engine.start import follow_branch
from snapjump.engine.status import ITERATION_LIMIT, STEP_UNDERFLOW
from snapjump.engine.step import Method, judge_step
from snapjump.engine.view import view_memory, view_work
from snapjump.number.array import uncounted
from snapjump.number.atomic import fetch_add
from snapjump.number.dispatch import released
from snapjump.number.functions import any_true, where

MOST_BACKTRACKS = 4.0  # in one stage


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
    stages = scheme.stage_count()
    last_stage = 1.0 * stages
    # What the last stage reached is used up at once, but for whoever watches.
    kept = stages if recorder.watches() or not scheme.ends_in_a_stage() else stages - 1
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
                StageLimits(
                    method.termination.newton_tolerance(work, stepping.newton_tolerance()),
                    stepping.newton_stick_share(),
                    method.most_in_stage,
                    MOST_BACKTRACKS,
                ),
            )
        clock[ITERATIONS] = clock[ITERATIONS] + where(active, 1.0, 0.0)
        converged = correction.converged & active
        failed = correction.failed & active
        restage = failed
        good = failed & converged  # none
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
            error = estimate_error(scheme, work, motion)
            keep_stage(scheme, work, motion, kept, converged)
            recorder.record_stage(model, masses, motion, scheme, work, converged)
            course = Course(clock[STAGE], converged, Ended(h, rates_of(motion)))
            ended = converged & (course.stage >= last_stage)
            clock[STAGE] = where(converged, clock[STAGE] + 1.0, clock[STAGE])
            if any_true(ended):
                good, status = judge_step(model, masses, method, work, ended, error, status)
            recorder.follow(model, masses, motion, scheme, work, course, good)
        if recorder.watches():
            if any_true(good):
                commit_step(scheme, work, h, rates_of(motion), good)
                recorder.record_step(model, masses, scheme, work, good)
        elif any_true(restage):
            move_on(model, scheme, masses, work, Ended(h, rates_of(motion)), good, restage)
        if any_true(good):
            status = where(good, method.termination.terminate(model, masses, work, good), status)
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
            if not recorder.watches():
                begin_stage(model, scheme, masses, work, leaving)
        if recorder.watches():
            if any_true(restage):
                begin_stage(model, scheme, masses, work, restage)
    return queue.counts[0] == 0
