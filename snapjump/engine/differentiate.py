"""Derivatives of a march's discrete steps, stage by stage, with the sizes of its steps frozen.

A stage solves R(q, p) = 0, so that K dq/dp = -dR/dp, with the predictors of the stage depending
on the parameters p as well. The tangent state takes the march's own guess of q, differentiated:
what the guess leaves of dR/dp comes out of the residual in duals, and is corrected with the matrix
that Newton's method has just factored. That one lacks unsymmetric parts that are small
(Kelvin-Voigt's, and friction's at nodes): each correction shrinks what they leave by a large
factor.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.assemble import Motion, assemble
from snapjump.engine.clock import LAST_STEP, STAGE, STEP, TIME
from snapjump.engine.model import with_numbers
from snapjump.engine.tangent import view_tangent
from snapjump.integrator.base import Reached
from snapjump.linear_solver.right_hand_sides import FOUR, solve_right_hand_sides
from snapjump.number.dispatch import kernel, routine
from snapjump.number.dual import constant, dual, slopes_of, value_of
from snapjump.number.lane import view_numbers


@routine
def ratio_of(memory: Any, lane: Any) -> Any:
    """A lane's step over its last one, 0 where there was none."""
    last = memory.clock[LAST_STEP, lane]
    return memory.clock[STEP, lane] / last if last > 0.0 else 0.0


@routine
def place_ends_at(model: Any, time: Any, work: Any) -> None:
    """Put the slave nodes where the clamps hold them at a time."""
    if model.discretization.has_elements():
        angles = model.clamp.angles(constant(time))
        model.frame.place_ends(work.mesh, model.discretization, angles, work.state)


@kernel
def tangent_model(template: Any, tangent: Any, lane: Any) -> Any:
    """The model of a lane in duals."""
    return with_numbers(template, view_tangent(tangent, lane).numbers)


@routine
def predict_stage(template: Any, scheme: Any, memory: Any, tangent: Any, lane: Any) -> None:
    """Begin the stage that a lane has just converged: its predictors and guess in duals."""
    work = view_tangent(tangent, lane)
    model = tangent_model(template, tangent, lane)
    stage = memory.clock[STAGE, lane]
    step = memory.clock[STEP, lane]
    ratio = ratio_of(memory, lane)
    rates = scheme.stage_rates(step, ratio)
    scheme.stage_coefficients(stage, step, ratio, work.coefficients)
    for i in range(work.state.shape[0]):
        position, velocity, guess = scheme.predict(work, i, stage, rates)
        work.position_predictor[i] = position
        work.velocity_predictor[i] = velocity
        # Where the matrix was assembled: there it belongs to the residual.
        before = memory.state[i, lane] + memory.correction[i, lane]
        work.state[i] = dual(before, slopes_of(guess))
    place_ends_at(model, memory.clock[TIME, lane] + scheme.abscissa(stage) * step, work)


@routine
def write_sides(model: Any, motion: Any, masses: Any, memory: Any, tangent: Any, lane: Any) -> None:
    """Assemble a lane's residual in duals and take its slopes as right-hand sides."""
    work = view_tangent(tangent, lane)
    # Here the compiler sees that they have no slopes.
    known = Motion(
        constant(motion.time),
        constant(motion.rate_factor),
        constant(motion.inertia_rate),
        constant(motion.anchor),
    )
    assemble(model, known, masses, work)
    sides = view_numbers(tangent.slopes[lane], FOUR)[HALF_BANDWIDTH:]
    frame_sides = view_numbers(tangent.frame_slopes[lane], FOUR)
    for i in range(work.residual.shape[0]):
        sides[i] = slopes_of(work.residual[i])
    for i in range(model.frame.dofs(memory.mesh)):
        frame_sides[i] = slopes_of(work.frame_residual[i])


@routine
def correct(model: Any, time: Any, memory: Any, tangent: Any, lane: Any) -> None:
    """Subtract the solved corrections from the slopes of a lane's state."""
    work = view_tangent(tangent, lane)
    dofs = model.frame.dofs(memory.mesh)
    sides = view_numbers(tangent.slopes[lane], FOUR)[HALF_BANDWIDTH:]
    frame_sides = view_numbers(tangent.frame_slopes[lane], FOUR)
    for i in range(work.state.shape[0]):
        change = frame_sides[i] if i < dofs else sides[i - dofs]
        before = work.state[i]
        work.state[i] = dual(value_of(before), slopes_of(before) - change)
    place_ends_at(model, time, work)


@routine
def differentiate_stages(
    template: Any,
    scheme: Any,
    masses: Any,
    memory: Any,
    tangent: Any,
    chosen: Any,
    count: int,
    corrections: int,
) -> None:
    """Bring the tangent states of the first ``count`` lanes in ``chosen`` through the stages that
    they have just converged."""
    rotations = template.discretization.node_dofs() == 3
    for c in range(count):
        predict_stage(template, scheme, memory, tangent, chosen[c])
    for _ in range(corrections):
        for c in range(count):
            lane = chosen[c]
            model = tangent_model(template, tangent, lane)
            motion = motion_of(scheme, memory, lane)
            write_sides(model, motion, masses, memory, tangent, lane)
        solve_right_hand_sides(
            memory, tangent.slopes, tangent.frame_slopes, chosen, count, rotations
        )
        for c in range(count):
            lane = chosen[c]
            node = scheme.abscissa(memory.clock[STAGE, lane])
            time = memory.clock[TIME, lane] + node * memory.clock[STEP, lane]
            model = tangent_model(template, tangent, lane)
            correct(model, time, memory, tangent, lane)
    for c in range(count):
        store(template, scheme, memory, tangent, chosen[c])


@routine
def motion_of(scheme: Any, memory: Any, lane: Any) -> Motion:
    """Time and rates of a lane's stage."""
    step = memory.clock[STEP, lane]
    rates = scheme.stage_rates(step, ratio_of(memory, lane))
    time = memory.clock[TIME, lane] + scheme.abscissa(memory.clock[STAGE, lane]) * step
    return Motion(time, rates.rate_factor, rates.inertia_rate, 0.0)


@routine
def store(template: Any, scheme: Any, memory: Any, tangent: Any, lane: Any) -> None:
    """Keep a lane's stage; after its last one move on to the end of the step."""
    work = view_tangent(tangent, lane)
    stage = memory.clock[STAGE, lane]
    step = memory.clock[STEP, lane]
    ratio = ratio_of(memory, lane)
    rates = scheme.stage_rates(step, ratio)
    slot = int(stage)
    for i in range(work.state.shape[0]):
        work.state[i] = dual(memory.state[i, lane], slopes_of(work.state[i]))
        reached = scheme.reached(work, i, step, rates)
        work.velocity[slot, i] = reached.velocity
        work.acceleration[slot, i] = reached.acceleration
    if not scheme.ends_in_a_stage():
        if stage >= 1.0 * scheme.stage_count():
            model = tangent_model(template, tangent, lane)
            scheme.end_step(work, step, True)
            place_ends_at(model, memory.clock[TIME, lane] + step, work)


@routine
def commit(scheme: Any, memory: Any, tangent: Any, lane: Any) -> None:
    """Make a lane's last stage the beginning of its next step; the clock has moved on already."""
    work = view_tangent(tangent, lane)
    last = scheme.stage_count()
    step = memory.clock[LAST_STEP, lane]
    for i in range(work.state.shape[0]):
        reached = Reached(work.velocity[last, i], work.acceleration[last, i])
        scheme.keep_history(work, i, step, reached, True)
        work.start[i] = work.state[i]
        work.velocity[0, i] = reached.velocity
        work.acceleration[0, i] = reached.acceleration
