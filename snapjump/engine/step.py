"""The end of a step: whether it stands, what is kept of it, and how large the next one is."""

from typing import Any, NamedTuple

from snapjump.engine.clock import (
    COARSEST,
    ERROR,
    ERROR_SUM,
    FAILURES,
    FASTEST,
    GAP,
    LAST_CONTACT,
    LAST_STEP,
    REJECTED,
    SMALLEST_GAP,
    SMALLEST_STABLE_STEP,
    STABLE_STEP,
    STAGE,
    STEP,
    STEPS,
    TIME,
)
from snapjump.engine.gaps import GAP_FRACTION, gap_safe_share, smallest_gap
from snapjump.engine.status import NOT_FINITE, STEP_UNDERFLOW
from snapjump.engine.sticking import settles_sliding
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import maximum, minimum, negate, sqrt, where

STABILITY_MARGIN = 0.9  # of the largest stable step, for what stiffens until the next one


class Method(NamedTuple):
    """How a march is stepped and ended: an integrator's scheme, a step control, a termination, and
    the most Newton iterations of a stage and of the whole march."""

    scheme: Any
    stepping: Any
    termination: Any
    most_in_stage: float
    most_in_march: float


@routine
def reach_end(model: Any, scheme: Any, masses: Any, work: Any, mask: Any) -> Any:
    """Move from the last stage to the end of the step, where that is no stage.

    Returns the mask of lanes whose step must be repeated: the end closed a gap.
    """
    clock = work.clock
    mesh = work.mesh
    dofs = model.frame.dofs(mesh)
    correction = work.correction
    for i in range(work.state.shape[0]):
        correction[i] = where(mask, work.state[i], correction[i])
    scheme.end_step(work, clock[STEP], mask)
    if model.discretization.has_elements():
        share = where(mask, 1.0, scheme.abscissa(clock[STAGE]))
        angles = model.clamp.angles(clock[TIME] + share * clock[STEP])
        model.frame.place_ends(mesh, model.discretization, angles, work.state)
    # Of its gap at the stage every point must keep GAP_FRACTION; said of the gap at the end, for
    # which that share of the way back stands in the correction's place until the next stage.
    for i in range(work.state.shape[0]):
        moved = GAP_FRACTION * (correction[i] - work.state[i])
        correction[i] = where(mask, moved, correction[i])
    allowed = gap_safe_share(model, masses, mesh, work.state, correction, correction[dofs:])
    clock[GAP] = where(mask, smallest_gap(model, masses, mesh, work.state), clock[GAP])
    return mask & (allowed < 1.0)


@kernel
def contact_frequency(work: Any) -> Any:
    """Fastest contact frequency of the last assembly (1/T)."""
    return sqrt(work.clock[FASTEST])


class Verdict(NamedTuple):
    """Of steps that have ended: the mask of those that stand, and the status of every lane."""

    good: Any
    status: Any


@routine
def judge_step(
    model: Any, masses: Any, method: Method, work: Any, ended: Any, error: Any, status: Any
) -> Verdict:
    """Judge the steps that have just ended, and choose the size of the next ones."""
    scheme = method.scheme
    stepping = method.stepping
    termination = method.termination
    clock = work.clock
    h = clock[STEP]
    rate = contact_frequency(work)
    factor = termination.tolerance_factor(model, work)
    if settles_sliding(model):
        sticking = stepping.stick_factor(h, model.friction.stick_speed())
        factor = where(rate > 0.0, minimum(factor, sticking), factor)
    error = error / factor
    good = ended & stepping.accepts(error, h, rate)
    if scheme.is_explicit():
        good = good & (h <= clock[STABLE_STEP])
    closed = h < 0.0
    if not scheme.ends_in_a_stage():
        closed = reach_end(model, scheme, masses, work, ended)
        good = good & negate(closed)
    bad = ended & negate(good)
    clock[ERROR] = error
    clock[ERROR_SUM] = clock[ERROR_SUM] + where(good, error, 0.0)
    clock[COARSEST] = where(good, maximum(clock[COARSEST], h * rate), clock[COARSEST])
    clock[STEPS] = clock[STEPS] + where(good, 1.0, 0.0)
    clock[REJECTED] = clock[REJECTED] + where(bad, 1.0, 0.0)
    clock[FAILURES] = where(good, 0.0, clock[FAILURES])
    clock[STAGE] = where(ended, 1.0, clock[STAGE])
    clock[SMALLEST_GAP] = where(good, minimum(clock[SMALLEST_GAP], clock[GAP]), clock[SMALLEST_GAP])
    clock[TIME] = where(good, clock[TIME] + h, clock[TIME])
    clock[LAST_STEP] = where(good, h, clock[LAST_STEP])
    touching = good & (clock[GAP] < model.ground.clearance)
    clock[LAST_CONTACT] = where(touching, clock[TIME], clock[LAST_CONTACT])
    finite = clock[TIME] + error < 1e30
    status = where(ended & negate(finite), 1.0 * NOT_FINITE, status)
    proposed = stepping.next_step(error, scheme.error_power(), h, rate)
    if not scheme.ends_in_a_stage():
        proposed = where(closed, stepping.step_after_failure(h), proposed)
    if scheme.is_explicit():
        stable = clock[STABLE_STEP]
        smallest = minimum(clock[SMALLEST_STABLE_STEP], stable)
        clock[SMALLEST_STABLE_STEP] = where(good, smallest, clock[SMALLEST_STABLE_STEP])
        proposed = minimum(proposed, STABILITY_MARGIN * stable)
    remaining = maximum(
        termination.time_limit(model) - clock[TIME], stepping.smallest_step() + 0.0 * h
    )
    clock[STEP] = where(ended, minimum(proposed, remaining), clock[STEP])
    under = bad & (clock[STEP] < stepping.smallest_step())
    return Verdict(good, where(under, 1.0 * STEP_UNDERFLOW, status))
