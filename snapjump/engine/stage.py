"""Stages and steps: what happens when a lane's Newton iteration has converged or failed."""

from typing import Any

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import BACKTRACKS, ITERATION, LAST_STEP, SHARE, SIZE, STAGE, STEP, TIME
from snapjump.engine.gaps import gap_safe_share
from snapjump.integrator.base import Rates
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import maximum, where


@kernel
def step_ratio(work: Any) -> Any:
    """This step over the last one, 0 where there was none."""
    last = work.clock[LAST_STEP]
    return where(last > 0.0, work.clock[STEP] / maximum(last, 1e-300 + 0.0 * last), 0.0)


@kernel
def stage_motion(scheme: Any, work: Any) -> Motion:
    """Time and rates of every lane's current stage."""
    clock = work.clock
    step = clock[STEP]
    rates = scheme.stage_rates(step, step_ratio(work))
    return Motion(
        clock[TIME] + scheme.abscissa(clock[STAGE]) * step,
        rates.rate_factor,
        rates.inertia_rate,
        0.0 * step,
    )


@routine
def keep_stage(scheme: Any, work: Any, motion: Any, mask: Any) -> Any:
    """Keep the stage that has just converged; returns the error (L) of steps that end with it."""
    clock = work.clock
    rates = Rates(motion.rate_factor, motion.inertia_rate)
    return scheme.store_stage(work, clock[STAGE], clock[STEP], step_ratio(work), rates, mask)


@routine
def begin_stage(model: Any, scheme: Any, masses: Any, work: Any, mask: Any) -> None:
    """Set both predictors and a gap-safe first guess of every masked lane's current stage."""
    clock = work.clock
    stage = clock[STAGE]
    step = clock[STEP]
    ratio = step_ratio(work)
    rates = scheme.stage_rates(step, ratio)
    size = work.state.shape[0]
    restart = mask & (stage == 1.0)
    scheme.stage_coefficients(stage, step, ratio, work.coefficients)
    for i in range(size):
        position, velocity, aim = scheme.predict(work, i, stage, rates)
        state = where(restart, work.start[i], work.state[i])
        work.position_predictor[i] = where(mask, position, work.position_predictor[i])
        work.velocity_predictor[i] = where(mask, velocity, work.velocity_predictor[i])
        work.state[i] = state
        work.correction[i] = where(mask, state - aim, work.correction[i])
    mesh = work.mesh
    drop = work.correction[model.frame.dofs(mesh) :]
    allowed = gap_safe_share(model, masses, mesh, work.state, work.correction, drop)
    allowed = where(mask, allowed, 0.0)
    for i in range(size):
        work.state[i] = work.state[i] - allowed * work.correction[i]
    for i in range(work.sliding_velocity.shape[0]):
        work.sliding_velocity[i] = where(mask, 0.0, work.sliding_velocity[i])
        work.active_set[i] = where(mask, 0.0, work.active_set[i])
    clock[ITERATION] = where(mask, 0.0, clock[ITERATION])
    clock[SIZE] = where(mask, 0.0, clock[SIZE])
    clock[SHARE] = where(mask, allowed, clock[SHARE])
    clock[BACKTRACKS] = where(mask, 0.0, clock[BACKTRACKS])
    if model.discretization.has_elements():
        time = clock[TIME] + scheme.abscissa(stage) * step
        angles = model.clamp.angles(time)
        model.frame.place_ends(mesh, model.discretization, angles, work.state)
