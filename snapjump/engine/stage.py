"""Stages and steps: what happens when a lane's Newton iteration has converged or failed."""

from typing import Any, NamedTuple

from snapjump.engine.air import feel_air
from snapjump.engine.assemble import Motion
from snapjump.engine.clock import BACKTRACKS, ITERATION, LAST_STEP, SHARE, SIZE, STAGE, STEP, TIME
from snapjump.engine.gaps import frame_gap_share, keeps_gaps, limited
from snapjump.engine.view import alone
from snapjump.integrator.base import Rates, Reached
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import any_true, fma, maximum, sqrt, where


class Ended(NamedTuple):
    """Sizes (T) of steps that end, and the rates of their last stage."""

    size: Any
    rates: Rates


class Course(NamedTuple):
    """Stages that have been solved: which (T), in which lanes they have converged (a mask), and the
    steps that they are of."""

    stage: Any
    converged: Any
    step: Ended


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
def begin_coordinate(scheme: Any, work: Any, i: Any, stage: Any, rates: Rates, mask: Any) -> Any:
    """Set the predictors of coordinate ``i`` and its guess; returns where that begins, and how far
    it falls from there, which in masked lanes is ``work.correction`` too."""
    position, velocity, aim = scheme.predict(work, i, stage, rates)
    restart = mask & (stage == 1.0)
    origin = where(restart, work.start[i], work.state[i])
    work.position_predictor[i] = where(mask, position, work.position_predictor[i])
    work.velocity_predictor[i] = where(mask, velocity, work.velocity_predictor[i])
    fall = origin - aim
    work.correction[i] = where(mask, fall, work.correction[i])
    work.state[i] = where(mask, aim, origin)
    return origin, where(mask, fall, 0.0)


@routine
def begin_stage(model: Any, scheme: Any, masses: Any, work: Any, mask: Any) -> None:
    """Set both predictors and a gap-safe first guess of every masked lane's current stage."""
    step = work.clock[STEP]
    nothing = Ended(step, scheme.stage_rates(step, step_ratio(work)))
    move_on(model, scheme, masses, work, nothing, mask & (step < 0.0), mask)


@routine
def move_on(
    model: Any, scheme: Any, masses: Any, work: Any, ended: Ended, good: Any, mask: Any
) -> None:
    """:func:`commit_step` of the lanes ``good``, then :func:`begin_stage` of those in ``mask``, in
    one sweep; ``ended``: the steps that have ended, after which the clock has moved on already."""
    clock = work.clock
    mesh = work.mesh
    stage = clock[STAGE]
    step = clock[STEP]
    ratio = step_ratio(work)
    rates = scheme.stage_rates(step, ratio)
    scheme.stage_coefficients(stage, step, ratio, work.coefficients)
    dofs = model.frame.dofs(mesh)
    for i in range(dofs):
        commit_coordinate(scheme, work, i, ended.size, ended.rates, good)
        origin, _ = begin_coordinate(scheme, work, i, stage, rates, mask)
        work.state[i] = origin
    share = 1.0 + 0.0 * step
    if keeps_gaps(model):
        share = frame_gap_share(model, masses, mesh, work.state, work.correction)
    share = where(mask, share, 1.0)
    for i in range(dofs):
        work.state[i] = work.state[i] - where(mask, work.correction[i], 0.0)
    if alone(work):
        share = move_coordinates(model, scheme, masses, work, ended, good, mask, share)
    else:
        share = move_nodes(model, scheme, masses, work, ended, good, mask, share)
    if any_true(share < 1.0):
        for i in range(work.state.shape[0]):
            work.state[i] = work.state[i] + (1.0 - share) * work.correction[i]
    forget_iterations(model, work, share, mask)
    if model.drag.exists():
        feel_air(model, masses, work, scheme.abscissa(stage) * step, mask)
    if model.discretization.has_elements():
        time = clock[TIME] + scheme.abscissa(stage) * step
        angles = model.clamp.angles(time)
        model.frame.place_ends(mesh, model.discretization, angles, work.state)


@kernel
def move_nodes(
    model: Any, scheme: Any, masses: Any, work: Any, ended: Ended, good: Any, mask: Any, share: Any
) -> Any:
    """Move the beam's nodes on; returns the share of their way that keeps gaps open."""
    stage = work.clock[STAGE]
    rates = scheme.stage_rates(work.clock[STEP], step_ratio(work))
    dofs = model.frame.dofs(work.mesh)
    per_node = model.discretization.node_dofs()
    for node in range(masses.shape[0]):
        for axis in range(per_node):
            i = dofs + per_node * node + axis
            commit_coordinate(scheme, work, i, ended.size, ended.rates, good)
            origin, fall = begin_coordinate(scheme, work, i, stage, rates, mask)
            if axis == 1:
                if keeps_gaps(model):
                    if masses[node] > 0.0:
                        share = limited(share, origin, fall)
    return share


@kernel
def move_coordinates(
    model: Any, scheme: Any, masses: Any, work: Any, ended: Ended, good: Any, mask: Any, share: Any
) -> Any:
    """The same of one robot, in two sweeps: one of coordinates, which the compiler takes several
    at a time of, then one of gaps. Where nodes begin is kept in the residual, which is over."""
    stage = work.clock[STAGE]
    rates = scheme.stage_rates(work.clock[STEP], step_ratio(work))
    dofs = model.frame.dofs(work.mesh)
    for i in range(dofs, work.state.shape[0]):
        commit_coordinate(scheme, work, i, ended.size, ended.rates, good)
        origin, _ = begin_coordinate(scheme, work, i, stage, rates, mask)
        work.residual[i - dofs] = origin
    if keeps_gaps(model):
        for node in range(masses.shape[0]):
            if masses[node] > 0.0:
                i = model.discretization.node_dofs() * node + 1
                fall = where(mask, work.correction[dofs + i], 0.0)
                share = limited(share, work.residual[i], fall)
    return share


@kernel
def forget_iterations(model: Any, work: Any, share: Any, mask: Any) -> None:
    """Forget what the masked lanes' last stages knew of their iterations; ``share``: of the way to
    the guess that is taken."""
    clock = work.clock
    if model.contact.exists() and model.friction.exists():
        for i in range(work.sliding_velocity.shape[0]):
            work.sliding_velocity[i] = where(mask, 0.0, work.sliding_velocity[i])
    if model.contact.is_constraint():
        for i in range(work.active_set.shape[0]):
            work.active_set[i] = where(mask, 0.0, work.active_set[i])
    clock[ITERATION] = where(mask, 0.0, clock[ITERATION])
    clock[SIZE] = where(mask, 0.0, clock[SIZE])
    clock[SHARE] = where(mask, share, clock[SHARE])
    clock[BACKTRACKS] = where(mask, 0.0, clock[BACKTRACKS])
