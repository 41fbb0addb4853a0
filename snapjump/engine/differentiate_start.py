"""Derivatives of the quasi-static start: of its equilibrium, velocity and acceleration."""

from typing import Any, NamedTuple

from snapjump.engine.assemble import Motion
from snapjump.engine.differentiate import correct, factorise, place_ends_at
from snapjump.engine.equilibrium import solve_equilibrium
from snapjump.engine.model import with_numbers
from snapjump.engine.start import DIFFERENCE_RAD, stay_in_place, with_angles
from snapjump.engine.status import RUNNING
from snapjump.engine.tangent import view_tangent, with_exact_system
from snapjump.engine.view import view_work
from snapjump.number.array import uncounted
from snapjump.number.dispatch import released, routine
from snapjump.number.dual import constant, dual, slope_at, slopes_of, value_of
from snapjump.number.dual_type import PARAMETERS
from snapjump.number.lane import view_numbers

FOUR = (0, 0, 0, 0)
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
def differentiate_equilibrium(plain: Any, model: Any, masses: Any, twin: Any, time: Any) -> None:
    """Slopes of the equilibrium at a time that the state is, of ``plain``, which ``model`` is in
    duals."""
    zero = 0.0 * time
    for i in range(twin.state.shape[0]):
        twin.state[i] = constant(zero)
        twin.position_predictor[i] = constant(zero)
    place_ends_at(model, time, twin)
    still = Motion(time, zero, zero, zero + WEAK_ANCHOR)
    sides = twin.bare_padded_residual
    factorise(plain, still, masses, with_exact_system(twin))
    for _ in range(MOST_CORRECTIONS):
        correct(model, still, masses, twin, twin)
        largest = zero
        for i in range(sides.shape[0]):
            for k in range(PARAMETERS):
                largest = max(largest, abs(slope_at(sides[i], k)))
        if largest < SMALL:
            break


@routine
def guess_at(work: Any, queue: Any, robot: int, time: float) -> None:
    """Put the state of a robot's branch at a time, by its tangent and curvature, into memory."""
    for i in range(work.state.shape[0]):
        bend = 0.5 * time * queue.acceleration[robot, i]
        work.state[i] = queue.state[robot, i] + time * (queue.velocity[robot, i] + bend)


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
    masses = uncounted(masses)
    work = view_work(uncounted(memory), (0,))
    twin = view_tangent(work, uncounted(tangent))
    for robot in range(first, last):
        if queue.status[robot] != RUNNING:
            continue
        given = view_numbers(slopes.numbers[robot], FOUR)
        for k in range(work.numbers.shape[0]):
            work.numbers[k] = queue.numbers[robot, k]
            twin.numbers[k] = dual(queue.numbers[robot, k], given[k])
        moving = with_numbers(template, work.numbers)
        model = with_angles(moving, moving.clamp.start, moving.clamp.delta_alpha)
        of_duals = with_numbers(template, twin.numbers)
        start = of_duals.clamp.start
        delta_alpha = of_duals.clamp.delta_alpha
        difference = DIFFERENCE_RAD / moving.clamp.rate
        # Faster clamps pass the same angles on both sides, only sooner.
        passing = DIFFERENCE_RAD / of_duals.clamp.rate
        sooner = difference * (of_duals.clamp.rate - moving.clamp.rate)
        now = with_angles(of_duals, start, delta_alpha)
        unlike = (of_duals.clamp.right_over_left() - 1.0) * sooner
        earlier = with_angles(of_duals, start + sooner, delta_alpha - unlike)
        later = with_angles(of_duals, start - sooner, delta_alpha + unlike)

        guess_at(work, queue, robot, 0.0)
        solve_equilibrium(model, masses, work, 0.0)
        differentiate_equilibrium(model, now, masses, twin, 0.0)
        for i in range(work.state.shape[0]):
            twin.start[i] = twin.state[i]
            work.start[i] = work.state[i]
        guess_at(work, queue, robot, -difference)
        solve_equilibrium(model, masses, work, -difference)
        differentiate_equilibrium(model, earlier, masses, twin, -difference)
        for i in range(work.state.shape[0]):
            twin.velocity[0, i] = twin.state[i]
            work.velocity[0, i] = work.state[i]
        guess_at(work, queue, robot, difference)
        solve_equilibrium(model, masses, work, difference)
        differentiate_equilibrium(model, later, masses, twin, difference)
        for i in range(work.state.shape[0]):
            before = twin.velocity[0, i]
            after = twin.state[i]
            velocity = (after - before) / (2.0 * passing)
            bend = (after - 2.0 * twin.start[i] + before) / (passing * passing)
            twin.velocity[0, i] = velocity
            twin.acceleration[0, i] = bend
            work.velocity[0, i] = value_of(velocity)
            work.acceleration[0, i] = value_of(bend)
        stay_in_place(of_duals, masses, twin)
        found = view_numbers(slopes.starts[robot], FOUR)
        for i in range(work.state.shape[0]):
            found[0, i] = slopes_of(twin.start[i])
            found[1, i] = slopes_of(twin.velocity[0, i])
            found[2, i] = slopes_of(twin.acceleration[0, i])
