"""Stages and steps: what happens when a lane's Newton iteration has converged or failed."""

from typing import Any

from snapjump.clamp.base import clamp_angles
from snapjump.discretization.base import has_elements
from snapjump.engine.clock import (
    BACKTRACKS,
    FASTEST,
    ITERATION,
    SIZE,
    STAGE,
    STEP,
    TIME,
)
from snapjump.engine.newton import allowed_share
from snapjump.frame.base import frame_dofs, place_ends
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import any_true, fma, sqrt, where


@kernel
def pick(table: Any, stage: Any) -> Any:
    """The table's entry at every lane's own stage."""
    value = 0.0 * stage
    for k in range(table.shape[0]):
        value = where(stage == 1.0 * k, table[k] + value, value)
    return value


@routine
def store_stage(tableau: Any, work: Any, mask: Any) -> Any:
    """Keep velocity and acceleration of the stage that has just converged.

    Returns the largest difference in position (L) from the comparison method, for lanes whose
    step has ended.
    """
    clock = work.clock
    last = len(tableau.error) - 1
    rate = 1.0 / (tableau.gamma * clock[STEP])
    for k in range(1, last):
        here = mask & (clock[STAGE] == 1.0 * k)
        if any_true(here):
            velocity = work.velocity[k]
            acceleration = work.acceleration[k]
            for i in range(work.state.shape[0]):
                v = (work.state[i] - work.origin[i]) * rate
                a = (v - work.drift[i]) * rate
                velocity[i] = where(here, v, velocity[i])
                acceleration[i] = where(here, a, acceleration[i])
    total = 0.0 * rate
    if any_true(mask & (clock[STAGE] >= 1.0 * last)):
        # The last stage is used up at once: other lanes' entries may be overwritten.
        velocity = work.velocity[last]
        acceleration = work.acceleration[last]
        for i in range(work.state.shape[0]):
            v = (work.state[i] - work.origin[i]) * rate
            velocity[i] = v
            acceleration[i] = (v - work.drift[i]) * rate
            error = tableau.error[last] * v
            for k in range(last):
                error = fma(tableau.error[k], work.velocity[k, i], error)
            total = fma(error, error, total)
    return sqrt(total / work.state.shape[0]) * clock[STEP]


@routine
def commit_step(tableau: Any, work: Any, mask: Any) -> None:
    """Make the last stage the beginning of the next step."""
    last = len(tableau.error) - 1
    clock = work.clock
    clock[TIME] = where(mask, clock[TIME] + clock[STEP], clock[TIME])
    for i in range(work.state.shape[0]):
        work.start[i] = where(mask, work.state[i], work.start[i])
        work.velocity[0, i] = where(mask, work.velocity[last, i], work.velocity[0, i])
        work.acceleration[0, i] = where(mask, work.acceleration[last, i], work.acceleration[0, i])


@routine
def begin_stage(model: Any, tableau: Any, masses: Any, work: Any, mask: Any) -> None:
    """Set origin, drift and a gap-safe first guess of every masked lane's current stage."""
    clock = work.clock
    stages = len(tableau.error)
    stage = clock[STAGE]
    step = clock[STEP]
    share = tableau.gamma * step
    size = work.state.shape[0]
    restart = mask & (stage == 1.0)
    for k in range(stages - 1):
        work.weights[k] = step * pick(tableau.matrix[:, k], stage)
    for i in range(size):
        position = work.start[i]
        origin = position
        drift = work.velocity[0, i]
        guess = work.acceleration[0, i]
        for k in range(stages - 1):
            earlier = work.acceleration[k, i]
            origin = fma(work.weights[k], work.velocity[k, i], origin)
            drift = fma(work.weights[k], earlier, drift)
            guess = where(stage > 1.0 * k, earlier, guess)
        state = where(restart, position, work.state[i])
        aim = origin + share * (drift + share * guess)
        work.origin[i] = where(mask, origin, work.origin[i])
        work.drift[i] = where(mask, drift, work.drift[i])
        work.state[i] = state
        work.change[i] = where(mask, state - aim, work.change[i])
    mesh = work.mesh
    drop = work.change[frame_dofs(model.frame, mesh) :]
    allowed = allowed_share(model, masses, mesh, work.state, work.change, drop)
    allowed = where(mask, allowed, 0.0)
    for i in range(size):
        work.state[i] = work.state[i] - allowed * work.change[i]
    for i in range(work.slip.shape[0]):
        work.slip[i] = where(mask, 0.0, work.slip[i])
    clock[ITERATION] = where(mask, 0.0, clock[ITERATION])
    clock[SIZE] = where(mask, 0.0, clock[SIZE])
    clock[BACKTRACKS] = where(mask, 0.0, clock[BACKTRACKS])
    if has_elements(model.discretization):
        time = clock[TIME] + pick(tableau.nodes, stage) * step
        angles = clamp_angles(model.clamp, time)
        place_ends(model.frame, mesh, model.discretization, angles, work.state)


@kernel
def contact_frequency(work: Any) -> Any:
    """Fastest contact frequency of the last assembly (1/T)."""
    return sqrt(work.clock[FASTEST])
