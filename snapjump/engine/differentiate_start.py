"""Derivatives of the quasi-static start: of its equilibrium, velocity and acceleration."""

from typing import Any, NamedTuple

import numpy as np

from snapjump.engine.assemble import Motion
from snapjump.engine.differentiate import correct, place_ends_at, tangent_model, write_sides
from snapjump.engine.equilibrium import solve_equilibrium
from snapjump.engine.linearised import solve_linearised
from snapjump.engine.model import with_numbers
from snapjump.engine.start import DIFFERENCE_RAD, stay_in_place, with_angles
from snapjump.engine.status import RUNNING
from snapjump.engine.tangent import view_tangent
from snapjump.engine.view import view_memory, view_work
from snapjump.linear_solver.right_hand_sides import FOUR, solve_right_hand_sides
from snapjump.number.array import uncounted
from snapjump.number.dispatch import released, routine
from snapjump.number.dual import PARAMETERS, constant, dual, slopes_of
from snapjump.number.lane import view_numbers

# The spring that holds x in statics, and those that bring lifted feet back, are no part of the
# equilibrium: nearly without them the matrix is its derivative, and few corrections are needed.
WEAK_ANCHOR = 1.0
MOST_CORRECTIONS = 30
SMALL = 1e-13  # correction (L by a parameter) after which there is no need of another


class StartSlopes(NamedTuple):
    """Derivatives by four parameters, of R robots: numbers (R, P, 4), of the models; starts
    (R, 3, D, 4), to be filled with those of state, velocity and acceleration."""

    numbers: Any
    starts: Any


@routine
def differentiate_equilibrium(
    model: Any, dual_start: Any, masses: Any, memory: Any, tangent: Any, chosen: Any, time: float
) -> None:
    """Slopes of the equilibrium near ``memory.state`` at a time, into the tangent's state."""
    work = view_work(memory, (0,))
    store = view_memory(memory)
    solve_equilibrium(model, masses, work, time)
    zero = 0.0 * time
    solve_linearised(model, Motion(time, zero, zero, zero + WEAK_ANCHOR), masses, work)
    duals = view_tangent(tangent, 0)
    for i in range(duals.state.shape[0]):
        duals.state[i] = constant(store.state[i, 0])
        duals.position_predictor[i] = constant(store.state[i, 0])
    place_ends_at(dual_start, time, duals)
    still = Motion(time, 0.0, 0.0, WEAK_ANCHOR)
    rotations = model.discretization.node_dofs() == 3
    for _ in range(MOST_CORRECTIONS):
        write_sides(dual_start, still, masses, store, tangent, 0)
        solve_right_hand_sides(store, tangent.slopes, tangent.frame_slopes, chosen, 1, rotations)
        correct(dual_start, time, store, tangent, 0)
        largest = 0.0
        for i in range(tangent.slopes.shape[1]):
            for k in range(PARAMETERS):
                largest = max(largest, abs(tangent.slopes[0, i, k]))
        if largest < SMALL:
            break


@routine
def guess_at(memory: Any, queue: Any, robot: int, time: float) -> None:
    """Put the state of a robot's branch at a time, by its tangent and curvature, into memory."""
    state = view_memory(memory).state
    for i in range(state.shape[0]):
        bend = 0.5 * time * queue.acceleration[robot, i]
        state[i, 0] = queue.state[robot, i] + time * (queue.velocity[robot, i] + bend)


@released
def differentiate_starts(
    template: Any,
    masses: Any,
    memory: Any,
    tangent: Any,
    queue: Any,
    slopes: StartSlopes,
    first: int,
    last: int,
) -> None:
    """Slopes of the starts of robots ``first`` to ``last`` - 1, which have been found already.

    ``memory``, ``tangent``: of one lane.
    """
    chosen = np.zeros(1, dtype=np.int64)
    masses = uncounted(masses)
    memory = uncounted(memory)
    tangent = uncounted(tangent)
    work = view_work(memory, (0,))
    duals = view_tangent(tangent, 0)
    for robot in range(first, last):
        if queue.status[robot] != RUNNING:
            continue
        given = view_numbers(slopes.numbers[robot], FOUR)
        for k in range(work.numbers.shape[0]):
            work.numbers[k] = queue.numbers[robot, k]
            duals.numbers[k] = dual(queue.numbers[robot, k], given[k])
        moving = with_numbers(template, work.numbers)
        model = with_angles(moving, moving.clamp.start, moving.clamp.delta_alpha)
        dual_model = tangent_model(template, tangent, 0)
        start = dual_model.clamp.start
        delta_alpha = dual_model.clamp.delta_alpha
        dual_start = with_angles(dual_model, start, delta_alpha)
        difference = DIFFERENCE_RAD / moving.clamp.rate
        # Faster clamps pass the same angles on both sides, only sooner.
        passing = DIFFERENCE_RAD / dual_model.clamp.rate
        sooner = difference * (dual_model.clamp.rate - moving.clamp.rate)
        earlier = with_angles(dual_model, start + sooner, delta_alpha)
        later = with_angles(dual_model, start - sooner, delta_alpha)

        guess_at(memory, queue, robot, 0.0)
        differentiate_equilibrium(model, dual_start, masses, memory, tangent, chosen, 0.0)
        for i in range(duals.state.shape[0]):
            duals.start[i] = duals.state[i]
        guess_at(memory, queue, robot, -difference)
        differentiate_equilibrium(model, earlier, masses, memory, tangent, chosen, -difference)
        for i in range(duals.state.shape[0]):
            duals.velocity[0, i] = duals.state[i]
        guess_at(memory, queue, robot, difference)
        differentiate_equilibrium(model, later, masses, memory, tangent, chosen, difference)
        for i in range(duals.state.shape[0]):
            before = duals.velocity[0, i]
            after = duals.state[i]
            now = duals.start[i]
            bend = after - 2.0 * now + before
            duals.velocity[0, i] = (after - before) / (2.0 * passing)
            duals.acceleration[0, i] = bend / (passing * passing)
        stay_in_place(dual_model, masses, duals)
        found = view_numbers(slopes.starts[robot], FOUR)
        for i in range(duals.state.shape[0]):
            found[0, i] = slopes_of(duals.start[i])
            found[1, i] = slopes_of(duals.velocity[0, i])
            found[2, i] = slopes_of(duals.acceleration[0, i])
