"""A jump with given steps, every stage solved to rounding by a Jacobian that nothing is left out
of: the program whose derivatives the sensitivities claim to be."""

from typing import Any

import numpy as np
from numba import njit

from snapjump.engine import clock as c
from snapjump.engine import outcome as outcomes
from snapjump.engine.assemble import assemble
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.differentiate import known, place_ends_at
from snapjump.engine.march import march
from snapjump.engine.model import with_numbers
from snapjump.engine.stage import begin_stage, commit_step, keep_stage, rates_of, stage_motion
from snapjump.engine.status import OK
from snapjump.engine.tangent import make_tangent_state, view_tangent
from snapjump.engine.view import view_work
from snapjump.number.dual import constant, dual, slope_at, slopes_of
from snapjump.number.dual_type import PARAMETERS
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
from snapjump.scenes.flight import flight
from snapjump.scenes.runner import March

MOST_ITERATIONS, TOLERANCE = 200, 1e-14
GAP_LEFT = 0.15
CALM = 3  # corrections that shrink as they should, after which they grow again


def adaptive_steps(jump: March) -> Any:
    """Sizes (T) of the steps that stand in a march of one robot whose start is found."""
    steps, done, count = [], False, 0.0
    while not done:
        done = march(*jump.arguments(jump.crew[0]), 1)
        clock = jump.queue.outcome[0] if done else jump.memory.clock[:, 0]
        if clock[c.STEPS] > count:
            count = clock[c.STEPS]
            steps.append(clock[c.LAST_STEP])
    return np.array(steps)


@njit(error_model="numpy")
def guess_stage(template: Any, scheme: Any, masses: Any, memory: Any) -> None:
    """Begin the lane's stage with the march's own guess."""
    work = view_work(memory, (0,))
    begin_stage(with_numbers(template, work.numbers), scheme, masses, work, work.clock[c.STEP] > 0)


@njit(error_model="numpy")
def linearise(
    template: Any,
    scheme: Any,
    masses: Any,
    memory: Any,
    tangent: Any,
    seeds: Any,
    residual: Any,
    jacobian: Any,
) -> None:
    """Residual (D) and Jacobian (D, D) at ``memory.state``, four columns at a time, along
    ``seeds`` (4, 4)."""
    work = view_work(memory, (0,))
    twin = view_tangent(work, tangent)
    seeds = view_numbers(seeds, (0, 0, 0, 0))
    size = work.state.shape[0]
    plain = with_numbers(template, work.numbers)
    model = with_numbers(template, twin.numbers)
    motion = stage_motion(scheme, work)
    angles = plain.clamp.angles(motion.time)
    plain.frame.place_ends(work.mesh, plain.discretization, angles, work.state)
    assemble(plain, motion, masses, work)
    for i in range(size):
        residual[i] = work.frame_residual[i] if i < 3 else work.residual[i - 3]
    for first in range(0, size, PARAMETERS):
        count = min(PARAMETERS, size - first)
        for i in range(size):
            twin.state[i] = constant(work.state[i])
        for k in range(count):
            twin.state[first + k] = dual(work.state[first + k], seeds[k])
        place_ends_at(model, motion.time, twin)
        assemble(model, known(motion), masses, twin)
        for i in range(size):
            row = twin.frame_residual[i] if i < 3 else twin.residual[i - 3]
            for k in range(count):
                jacobian[i, first + k] = slope_at(slopes_of(row), k)


@njit(error_model="numpy")
def finish_stage(template: Any, scheme: Any, masses: Any, memory: Any) -> bool:
    """Keep the stage; whether it was the step's last, which is then committed."""
    work = view_work(memory, (0,))
    model = with_numbers(template, work.numbers)
    motion = stage_motion(scheme, work)
    angles = model.clamp.angles(motion.time)
    model.frame.place_ends(work.mesh, model.discretization, angles, work.state)
    everyone = work.clock[c.STEP] > 0.0
    keep_stage(scheme, work, motion, scheme.stage_count(), everyone)
    last = work.clock[c.STAGE] >= scheme.stage_count()
    if last:
        step = work.clock[c.STEP]
        commit_step(scheme, work, step, rates_of(motion), everyone)
        work.clock[c.TIME] += step
        work.clock[c.LAST_STEP] = step
        work.clock[c.STAGE] = 1.0
    else:
        work.clock[c.STAGE] += 1.0
    return last


def load(jump: March) -> None:
    """Put the robot of a march whose start is found into its lane."""
    memory, queue = jump.memory, jump.queue
    memory.numbers[:, 0] = queue.numbers[0]
    memory.state[:, 0] = memory.start[:, 0] = queue.state[0]
    memory.velocity[:, :, 0] = queue.velocity[0]
    memory.acceleration[:, :, 0] = queue.acceleration[0]
    memory.clock[:] = 0.0
    memory.clock[c.STAGE] = 1.0


def solve_stage(jump: March, tangent: Any) -> None:
    """Newton's method at the current guess, gaps kept open, until rounding is all that is left."""
    memory = jump.memory
    size = len(memory.state)
    residual, jacobian = np.zeros(size), np.zeros((size, size))
    dofs = jump.models[0].discretization.node_dofs()
    free = np.r_[0:3, 3 + dofs : size - dofs]
    before, damping, share, calm = np.inf, 1.0, 1.0, 0
    seeds = aligned_zeros((PARAMETERS, PARAMETERS))
    seeds[:] = np.eye(PARAMETERS)
    for count in range(MOST_ITERATIONS):
        where = (jump.models[0], jump.scheme, jump.masses, memory, tangent)
        linearise(*where, seeds, residual, jacobian)
        change = np.linalg.solve(jacobian[np.ix_(free, free)], residual[free])
        largest = float(np.abs(change).max())
        # Across the kinks of friction full corrections may go to and fro for ever.
        if count > 15:
            calm = calm + 1 if largest < (1.0 - 0.5 * share) * before else 0
            if calm == 0:
                damping = max(0.5 * damping, 0.02)
            elif calm > CALM:
                damping = min(1.4 * damping, 1.0)
        share = min(damping, 1e-3 / largest)
        gaps, falls = memory.state[4 + dofs : size - dofs : dofs, 0], change[4::dofs]
        closing = falls > (1.0 - GAP_LEFT) * gaps
        if closing.any():
            share = min(share, float(((1.0 - GAP_LEFT) * gaps[closing] / falls[closing]).min()))
        memory.state[free, 0] -= share * change
        if largest < TOLERANCE or (largest < 1e-11 and largest >= before):
            return
        before = largest
    raise ArithmeticError(f"no solution: the last correction was {largest:.2g}")


def exact_jump(jump: March, steps: Any, guide: Any = None) -> Any:
    """March the robot through the steps; returns the state (stages, D) that solves every stage.
    ``guide``: solutions of a robot nearby, to begin from."""
    load(jump)
    tangent = make_tangent_state(jump.memory)
    arguments = (jump.models[0], jump.scheme, jump.masses, jump.memory)
    solutions: list[Any] = []
    for step in steps:
        jump.memory.clock[c.STEP] = step
        last = False
        while not last:
            guess_stage(*arguments)
            if guide is not None:
                jump.memory.state[:, 0] = guide[len(solutions)]
            solve_stage(jump, tangent)
            last = finish_stage(*arguments)
            solutions.append(jump.memory.state[:, 0].copy())
    return np.array(solutions)


def outcome_of(jump: March) -> Any:
    """The outcome (1, COLUMNS) of a robot that flies after the last step."""
    memory, outcome = jump.memory, np.zeros((1, outcomes.COLUMNS))
    state, velocity = memory.start[:, 0], memory.velocity[0, :, 0]
    flying = centre_of_mass(jump.models[0], jump.masses, jump.mesh, state, velocity)
    columns = (outcomes.STATUS, outcomes.COM_X, outcomes.COM_Y, outcomes.COM_VX, outcomes.COM_VY)
    outcome[0, columns] = OK, *flying
    return outcome


def apex(jump: March) -> Any:
    """Apex (x, y) of the flight after the last step."""
    model = jump.models[0]
    flown = flight(0.0, model.load, outcome_of(jump)[0], model.drag)
    return np.array([flown.apex_x, flown.apex_y])


def march_along(jump: March, steps: Any, solutions: Any) -> None:
    """March with the recorder that the march has, through given steps and solutions of stages.
    Its stepping must accept everything, and its ending the end of the last step."""
    arguments = jump.arguments(jump.crew[0])
    march(*arguments, 0)
    memory, count = jump.memory, 0
    for step in steps:
        for _ in range(jump.scheme.stage_count()):
            memory.clock[c.STEP] = step
            guess_stage(jump.models[0], jump.scheme, jump.masses, memory)
            memory.state[:, 0] = solutions[count]
            memory.correction[:] = 0.0
            march(*arguments, 1)
            count += 1
    assert jump.queue.outcome[0, outcomes.STEPS] == len(steps)
