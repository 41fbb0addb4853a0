"""Stages and steps: what happens when a lane's Newton iteration has converged or failed."""

from typing import Any, NamedTuple

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import BACKTRACKS, ITERATION, LAST_STEP, SHARE, SIZE, STAGE, STEP, TIME
from snapjump.engine.gaps import gap_safe_share
from snapjump.integrator.base import Rates, Reached
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import any_true, fma, maximum, sqrt, where


class Ended(NamedTuple):
    """Sizes (T) of steps that end, and the rates of their last stage."""

    size: Any
    rates: Rates


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


@kernel
def rates_of(motion: Motion) -> Rates:
    """The rates of a stage."""
    return Rates(motion.rate_factor, motion.inertia_rate)


@routine
def estimate_error(scheme: Any, work: Any, motion: Motion) -> Any:
    """Error (L, root mean square over the coordinates) of steps that end with the stage at hand."""
    step = work.clock[STEP]
    ratio = step_ratio(work)
    rates = rates_of(motion)
    total = 0.0 * step
    for i in range(work.state.shape[0]):
        error = scheme.error(work, i, step, ratio, scheme.reached(work, i, step, rates))
        total = fma(error, error, total)
    return sqrt(total / work.state.shape[0]) * scheme.error_scale(step, ratio)


@routine
def keep_stage(scheme: Any, work: Any, motion: Motion, last: Any, mask: Any) -> None:
    """Keep velocity and acceleration of the masked lanes' stages up to ``last`` in their slots."""
    stage = work.clock[STAGE]
    step = work.clock[STEP]
    rates = rates_of(motion)
    for k in range(1, last + 1):
        here = mask & (stage == 1.0 * k)
        if any_true(here):
            velocity = work.velocity[k]
            acceleration = work.acceleration[k]
            for i in range(work.state.shape[0]):
                reached = scheme.reached(work, i, step, rates)
                velocity[i] = where(here, reached.velocity, velocity[i])
                acceleration[i] = where(here, reached.acceleration, acceleration[i])


@kernel
def commit_coordinate(scheme: Any, work: Any, i: Any, step: Any, rates: Rates, mask: Any) -> None:
    """Make what coordinate ``i`` has at the last stage the beginning of the next step."""
    reached = scheme.reached(work, i, step, rates)
    if not scheme.ends_in_a_stage():
        last = scheme.stage_count()
        reached = Reached(work.velocity[last, i], work.acceleration[last, i])
    scheme.keep_history(work, i, step, reached, mask)
    work.start[i] = where(mask, work.state[i], work.start[i])
    work.velocity[0, i] = where(mask, reached.velocity, work.velocity[0, i])
    work.acceleration[0, i] = where(mask, reached.acceleration, work.acceleration[0, i])


@routine
def commit_step(scheme: Any, work: Any, step: Any, rates: Rates, mask: Any) -> None:
    """Make the last stage, of steps of the given size, the beginning of the next step."""
    for i in range(work.state.shape[0]):
        commit_coordinate(scheme, work, i, step, rates, mask)


@kernel
def begin_coordinate(scheme: Any, work: Any, i: Any, stage: Any, rates: Rates, mask: Any) -> None:
    """Set the predictors of coordinate ``i`` and its guess, before that is kept from closing a gap;
    ``work.correction`` is how far the guess is from where it starts."""
    position, velocity, aim = scheme.predict(work, i, stage, rates)
    restart = mask & (stage == 1.0)
    state = where(restart, work.start[i], work.state[i])
    work.position_predictor[i] = where(mask, position, work.position_predictor[i])
    work.velocity_predictor[i] = where(mask, velocity, work.velocity_predictor[i])
    work.state[i] = state
    work.correction[i] = where(mask, state - aim, work.correction[i])


@routine
def begin_stage(model: Any, scheme: Any, masses: Any, work: Any, mask: Any) -> None:
    """Set both predictors and a gap-safe first guess of every masked lane's current stage."""
    clock = work.clock
    stage = clock[STAGE]
    step = clock[STEP]
    ratio = step_ratio(work)
    rates = scheme.stage_rates(step, ratio)
    scheme.stage_coefficients(stage, step, ratio, work.coefficients)
    for i in range(work.state.shape[0]):
        begin_coordinate(scheme, work, i, stage, rates, mask)
    guess(model, scheme, masses, work, mask)


@routine
def move_on(
    model: Any, scheme: Any, masses: Any, work: Any, ended: Any, good: Any, mask: Any
) -> None:
    """:func:`commit_step` of the lanes ``good`` and :func:`begin_stage` of those in ``mask``, in
    one sweep; ``ended``: sizes and rates of the steps that end, the clock has moved on already."""
    clock = work.clock
    stage = clock[STAGE]
    step = clock[STEP]
    ratio = step_ratio(work)
    rates = scheme.stage_rates(step, ratio)
    scheme.stage_coefficients(stage, step, ratio, work.coefficients)
    for i in range(work.state.shape[0]):
        commit_coordinate(scheme, work, i, ended.size, ended.rates, good)
        begin_coordinate(scheme, work, i, stage, rates, mask)
    guess(model, scheme, masses, work, mask)


@kernel
def guess(model: Any, scheme: Any, masses: Any, work: Any, mask: Any) -> None:
    """Move the masked lanes to their guesses as far as every gap stays open, and forget what their
    last stage knew of its iterations."""
    clock = work.clock
    mesh = work.mesh
    drop = work.correction[model.frame.dofs(mesh) :]
    allowed = gap_safe_share(model, masses, mesh, work.state, work.correction, drop)
    allowed = where(mask, allowed, 0.0)
    for i in range(work.state.shape[0]):
        work.state[i] = work.state[i] - allowed * work.correction[i]
    for i in range(work.sliding_velocity.shape[0]):
        work.sliding_velocity[i] = where(mask, 0.0, work.sliding_velocity[i])
        work.active_set[i] = where(mask, 0.0, work.active_set[i])
    clock[ITERATION] = where(mask, 0.0, clock[ITERATION])
    clock[SIZE] = where(mask, 0.0, clock[SIZE])
    clock[SHARE] = where(mask, allowed, clock[SHARE])
    clock[BACKTRACKS] = where(mask, 0.0, clock[BACKTRACKS])
    if model.discretization.has_elements():
        time = clock[TIME] + scheme.abscissa(clock[STAGE]) * clock[STEP]
        angles = model.clamp.angles(time)
        model.frame.place_ends(mesh, model.discretization, angles, work.state)
