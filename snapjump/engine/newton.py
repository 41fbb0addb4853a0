"""One Newton iteration of every lane: assemble, solve, keep every gap open, step."""

from typing import Any, NamedTuple

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import BACKTRACKS, FASTEST, GAP, ITERATION, RESIDUAL, SHARE, SIZE
from snapjump.engine.gaps import gap_safe_share
from snapjump.engine.linearised import Solution, solve_in_registers, solve_linearised
from snapjump.engine.sticking import settles_sliding, unsettled_sliding
from snapjump.number.dispatch import routine
from snapjump.number.functions import any_true, maximum, minimum, negate, where
from snapjump.number.methods import Contract

# Rate of convergence that a stage's first iteration is credited with: its guess follows the motion.
# Measured rates of jumps lie below.
FIRST_RATE = 0.1
GROWTH_LIMIT = 2.0  # of the correction, above which the last one is halved
LARGEST_CORRECTION = 0.3  # of the beam's length
ROUNDING = 2.0**-50  # of the length: what rounding of a point's few coordinates adds up to
LARGEST_SHAKE = 1e-6  # of the length: corrections beyond are more than rounding
SHRINKING = 0.5  # of the last correction: a smaller one still converges


class Limits(Contract):
    """What Newton's iterations may leave, and how many there may be: an error (L); of a foot's
    sliding a share of the speed below which friction sticks; iterations and backtracks of a stage.
    """

    error: Any
    stick_share: Any
    most_iterations: Any
    most_backtracks: Any

    def solve_system(self, model: Any, motion: Motion, masses: Any, work: Any) -> Solution:
        """Assemble the system of an iteration and solve it."""
        return solve_linearised(model, motion, masses, work)


@Limits.member
class StaticLimits(NamedTuple):
    """Of an equilibrium."""

    error: Any
    stick_share: Any
    most_iterations: Any
    most_backtracks: Any


@Limits.member
class StageLimits(NamedTuple):
    """Of a stage of a march, which has most of a jump's iterations: worth a program of its own."""

    error: Any
    stick_share: Any
    most_iterations: Any
    most_backtracks: Any

    def solve_system(self, model: Any, motion: Motion, masses: Any, work: Any) -> Solution:
        return solve_in_registers(model, motion, masses, work)


class Correction(NamedTuple):
    """Of an iteration: masks of the lanes that have converged and that have failed, and how many
    pivots are not positive."""

    converged: Any
    failed: Any
    negative_pivots: Any


@routine
def newton_iteration(
    model: Any, motion: Motion, masses: Any, work: Any, mask: Any, limits: Any
) -> Correction:
    """Correct ``work.state`` in the masked lanes; what is returned of the others is void."""
    clock = work.clock
    size = work.state.shape[0]
    dofs = model.frame.dofs(work.mesh)
    tiny = 1e-300 + 0.0 * motion.rate_factor
    x = work.residual
    y = work.frame_residual
    solution = limits.solve_system(model, motion, masses, work)
    extremes = solution.extremes
    correction = solution.correction
    clock[GAP] = extremes.smallest_gap
    clock[FASTEST] = extremes.contact_rate_squared
    force = maximum(extremes.largest_force, tiny)
    residual = solution.residual / force
    larger = maximum(residual, clock[RESIDUAL])  # of this iteration's and the last one's
    clock[RESIDUAL] = residual
    finite = correction < 1e30
    first = clock[ITERATION] == 0.0
    grew = (correction > GROWTH_LIMIT * clock[SIZE]) & negate(first)
    back = grew & (clock[BACKTRACKS] < limits.most_backtracks) & finite & mask
    # A correction that outgrows the last one tells that the last one went too far: halve that.
    half = 0.5 * clock[SHARE]
    share = minimum(
        gap_safe_share(model, masses, work.mesh, work.state, y, x),
        LARGEST_CORRECTION / maximum(correction, tiny),
    )
    share = where(finite & mask, share, 0.0)
    taken = where(back, 0.0, share)
    undoing = where(back, half, 0.0)
    for i in range(size):
        step = y[i] if i < dofs else x[i - dofs]
        step = where(finite, step, 0.0)
        work.state[i] = work.state[i] - taken * step + undoing * work.correction[i]
        work.correction[i] = where(back, work.correction[i], step)
    if model.discretization.has_elements():
        angles = model.clamp.angles(motion.time)
        model.frame.place_ends(work.mesh, model.discretization, angles, work.state)

    # The error left is about the correction times the rate of convergence, of which a correction
    # that was cut short says nothing: a huge one would make the next look converged.
    moving = motion.inertia_rate > 0.0
    seen = minimum(correction / maximum(clock[SIZE], tiny), 1.0 + 0.0 * tiny)
    rate = where(first, where(moving, FIRST_RATE, 1.0), seen)
    rate = where(clock[SHARE] < 1.0, 1.0, rate)
    # Corrections that shrink no more, while residuals are what rounding leaves of their terms,
    # shake the best state that there is. Twice, since Newton's method on a stiff chain stretches
    # and straightens it in turn.
    shaken = (larger * force <= ROUNDING * model.discretization.axial_stiffness()) & negate(first)
    shaken = shaken & (correction >= SHRINKING * clock[SIZE]) & (correction <= LARGEST_SHAKE)
    exact = (rate * correction <= limits.error) | shaken
    if settles_sliding(model):
        if any_true(exact & mask):
            left = rate * unsettled_sliding(model, motion.rate_factor, masses, work)
            exact = exact & (left <= limits.stick_share * model.friction.stick_speed())
    converged = exact & (share >= 1.0) & negate(back) & finite
    iteration = clock[ITERATION] + 1.0
    failed = (iteration >= limits.most_iterations) & negate(converged) | negate(finite)
    clock[ITERATION] = iteration
    clock[SIZE] = where(back, clock[SIZE], correction)
    clock[SHARE] = where(back, half, share)
    clock[BACKTRACKS] = clock[BACKTRACKS] + where(back, 1.0, 0.0)
    return Correction(converged, failed, solution.negative_pivots)
