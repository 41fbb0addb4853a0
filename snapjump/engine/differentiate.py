"""Derivatives of a march's discrete steps, stage by stage, with the sizes of its steps frozen.

A stage solves R(q, p) = 0, so that K dq/dp = -dR/dp, with the predictors of the stage depending
on the parameters p as well. The right-hand side comes out of the residual in duals, all lanes at
once, with the matrix K beside it: of elements that tell what the symmetric one lacks it is exact,
and solved with once. With other elements the state takes the march's own guess of q,
differentiated, and each correction shrinks what is wrong with it.
"""

from typing import Any

from numba.extending import overload

from snapjump.engine.air import feel_air
from snapjump.engine.assemble import Motion, add_node, assemble_nodes, begin_again, begin_assembly
from snapjump.engine.clock import TIME
from snapjump.engine.linearised import ENDS
from snapjump.engine.model import with_numbers
from snapjump.engine.stage import Course
from snapjump.engine.tangent import with_exact_system, with_state_held
from snapjump.integrator.base import Reached
from snapjump.linear_solver.banded_unsymmetric import (
    eliminate_frame,
    eliminate_unsymmetric,
    solve_sides,
)
from snapjump.linear_solver.contact_rows import NodeRows, rows_of
from snapjump.number.dispatch import INLINED, kernel, routine
from snapjump.number.dual import constant, slopes_of, value_of
from snapjump.number.functions import any_true, where
from snapjump.number.nowhere import nowhere
from snapjump.number.own_rows import own_rows


@routine
def place_ends_at(model: Any, time: Any, work: Any) -> None:
    """Put the slave nodes where the clamps hold them at a time."""
    if model.discretization.has_elements():
        angles = model.clamp.angles(constant(time))
        model.frame.place_ends(work.mesh, model.discretization, angles, work.state)


@kernel
def known(motion: Motion) -> Motion:
    """Time and rates of a stage in duals; here the compiler sees that they have no slopes."""
    return Motion(
        constant(motion.time),
        constant(motion.rate_factor),
        constant(motion.inertia_rate),
        constant(motion.anchor),
    )


@kernel
def eliminate_nodes(work: Any, dofs: Any, first: Any, end: Any) -> None:
    """Eliminate nodes from ``first`` up to ``end``, which stand in memory."""
    for node in range(first, end):
        eliminate_unsymmetric(work, node, dofs, rows_of(work, dofs * node), True)


@routine
def factorise(model: Any, motion: Motion, masses: Any, work: Any) -> None:
    """Assemble and eliminate the matrix of a stage, that nothing is left out of; ``model`` and
    ``work`` in plain numbers."""
    nodes = masses.shape[0]
    dofs = model.discretization.node_dofs()
    zero = 0.0 * motion.rate_factor
    begin = nodes
    end = nodes
    if dofs == 2 and nodes >= 2 * ENDS:
        begin = ENDS
        end = nodes - ENDS
    sweep = begin_assembly(model, motion, masses, work)
    sweep = assemble_nodes(model, motion, masses, work, 0, begin, sweep)
    eliminate_nodes(work, dofs, 0, begin)
    residual, band, skew = own_rows(zero)
    rows = NodeRows(residual, band, skew, 0)
    for node in range(begin, end):
        sweep = add_node(model, motion, masses, work, node, 2, sweep, rows)
        eliminate_unsymmetric(work, node, dofs, rows, False)
    assemble_nodes(model, motion, masses, work, end, nodes, sweep)
    eliminate_nodes(work, dofs, end, nodes)
    eliminate_frame(work)


@routine
def write_sides(model: Any, plain: Motion, masses: Any, work: Any, held: Any) -> None:
    """Assemble a stage's residual in duals, whose slopes are right-hand sides.

    ``held``: the same memory; or one whose state does not depend on parameters, where only the
    clamps' own nodes do so far.
    """
    nodes = masses.shape[0]
    motion = known(plain)
    sweep = begin_assembly(model, motion, masses, work)
    if model.discretization.node_dofs() == 3 or nodes <= 2 * ENDS:
        assemble_nodes(model, motion, masses, work, 0, nodes, sweep)
    else:
        sweep = assemble_nodes(model, motion, masses, work, 0, ENDS, sweep)
        # From the first node on once more, so that nothing carried is of what is not held.
        sweep = begin_again(model, motion, held, sweep)
        residual, _, _ = own_rows(0.0 * motion.rate_factor)
        rows = NodeRows(residual, nowhere(), nowhere(), 0)
        sides = work.bare_residual
        end = nodes - ENDS - 1  # whose edge ahead is the last that no clamp holds
        for node in range(end):
            sweep = add_node(model, motion, masses, held, node, 2, sweep, rows)
            if node >= ENDS:
                sides[2 * node] = slopes_of(residual[0])
                sides[2 * node + 1] = slopes_of(residual[1])
        assemble_nodes(model, motion, masses, work, end, nodes, sweep)


@routine
def correct(model: Any, plain: Motion, masses: Any, work: Any, held: Any) -> None:
    """Subtract from the slopes of a state what solves the linear system of the stage.

    With ``held`` slopes of nodes between the clamps' are none before.
    """
    write_sides(model, plain, masses, work, held)
    solve_sides(with_exact_system(work), work.bare_padded_residual, work.bare_frame_residual)
    frame = model.frame.dofs(work.mesh)
    slave = frame + model.discretization.node_dofs()
    size = work.state.shape[0]
    sides = work.bare_residual
    state = work.bare_state
    for i in range(frame):
        state[i] = state[i] - work.bare_frame_residual[i]
    for i in range(slave, size - (slave - frame)):
        state[i] = before_in(held, i) - sides[i - frame]
    place_ends_at(model, plain.time, work)


@kernel
def before_in(work: Any, i: Any) -> Any:
    """Slopes of a coordinate."""
    return slopes_of(work.state[i])


@routine
def differentiate_stage(
    model: Any, scheme: Any, masses: Any, work: Any, motion: Motion, course: Course, most: int
) -> None:
    """Bring the slopes of every lane's state through the stage at hand; ``most``: corrections where
    the matrix is not exact."""
    guessed = not model.discretization.tells_skew()
    for i in range(work.state.shape[0]):
        position, velocity, guess = scheme.predict(work, i, course.stage, course.step.rates)
        work.position_predictor[i] = position
        work.velocity_predictor[i] = velocity
        if guessed:
            work.state[i] = guess
    if model.drag.exists():
        ahead = scheme.abscissa(course.stage) * course.step.size
        feel_air(model, masses, work, constant(ahead), course.converged)
    if not guessed:
        forget_ends(model, work)
    place_ends_at(model, motion.time, work)
    exact = with_exact_system(work)
    factorise(with_numbers(model, exact.numbers), motion, masses, exact)
    held = state_held(model.discretization, work)
    for _ in range(most if guessed else 1):
        correct(model, motion, masses, work, held)


def state_held(discretization: Any, work: Any) -> Any:
    """Where right-hand sides are assembled: of an exact matrix, with a state that is held."""
    raise NotImplementedError("duals are compiled")


@overload(state_held, strict=False, jit_options=INLINED)
def _state_held(discretization: Any, work: Any) -> Any:
    if discretization.instance_class.tells_skew(None):
        return lambda discretization, work: with_state_held(work)
    return lambda discretization, work: work


@kernel
def forget_ends(model: Any, work: Any) -> None:
    """Let the frame and all nodes that the clamps' equations are of depend on no parameter."""
    size = work.state.shape[0]
    reach = model.frame.dofs(work.mesh) + (ENDS + 2) * model.discretization.node_dofs()
    zero = 0.0 * work.state[0]
    for i in range(min(reach, size)):
        work.state[i] = constant(value_of(zero))
    for i in range(max(size - reach, 0), size):
        work.state[i] = constant(value_of(zero))


@routine
def keep_slopes(scheme: Any, work: Any, course: Course, last: int) -> None:
    """Keep the slopes of converged stages up to ``last`` in their slots."""
    for k in range(1, last + 1):
        here = course.converged & (course.stage == 1.0 * k)
        if any_true(here):
            velocity = work.velocity[k]
            acceleration = work.acceleration[k]
            for i in range(work.state.shape[0]):
                reached = scheme.reached(work, i, course.step.size, course.step.rates)
                velocity[i] = where(here, reached.velocity, velocity[i])
                acceleration[i] = where(here, reached.acceleration, acceleration[i])


@routine
def commit_slopes(scheme: Any, work: Any, course: Course, good: Any) -> None:
    """Make the last stage of the lanes ``good`` the beginning of their next step."""
    last = scheme.stage_count()
    for i in range(work.state.shape[0]):
        reached = scheme.reached(work, i, course.step.size, course.step.rates)
        if not scheme.ends_in_a_stage():
            reached = Reached(work.velocity[last, i], work.acceleration[last, i])
        scheme.keep_history(work, i, course.step.size, reached, good)
        work.start[i] = where(good, work.state[i], work.start[i])
        work.velocity[0, i] = where(good, reached.velocity, work.velocity[0, i])
        work.acceleration[0, i] = where(good, reached.acceleration, work.acceleration[0, i])


@routine
def end_slopes(model: Any, scheme: Any, work: Any, course: Course, ended: Any) -> None:
    """Move on from the last stage to the end of the step, in lanes ``ended``, where that is no
    stage."""
    scheme.end_step(work, course.step.size, ended)
    share = where(ended, 1.0, scheme.abscissa(course.stage))
    place_ends_at(model, work.clock[TIME] + share * course.step.size, work)
