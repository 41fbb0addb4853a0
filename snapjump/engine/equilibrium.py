"""Static equilibrium: the stage problem without inertia, followed along the clamps' rotation."""

from typing import Any

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import BACKTRACKS, ITERATION, SIZE
from snapjump.engine.newton import StaticLimits, newton_iteration
from snapjump.number.dispatch import routine
from snapjump.number.functions import any_true, negate, where

ANCHOR = 1e3  # spring that holds the x that statics leaves undetermined (EI/L^3)
MOST_ITERATIONS = 60
LIMITS = StaticLimits(1e-10, 1.0, 1.0 * MOST_ITERATIONS, 0.0)


@routine
def solve_equilibrium(model: Any, masses: Any, work: Any, time: Any) -> Any:
    """Newton's method from ``work.state`` to the equilibrium at the clamps' angles of ``time``.

    Returns the number of negative pivots (0: stable) and the mask of lanes that failed.
    """
    clock = work.clock
    zero = 0.0 * clock[ITERATION]
    motion = Motion(time + zero, zero, zero, zero + ANCHOR)
    clock[ITERATION] = zero
    clock[SIZE] = zero
    clock[BACKTRACKS] = zero
    dofs = model.frame.dofs(work.mesh)
    angles = model.clamp.angles(motion.time)
    model.frame.place_ends(work.mesh, model.discretization, angles, work.state)
    for i in range(dofs, work.state.shape[0]):
        work.position_predictor[i] = work.state[i]
    negative = zero
    done = zero > 1.0
    failed = zero > 1.0
    for _ in range(MOST_ITERATIONS):
        # Lanes that are done stay as they are: their result must not depend on the others.
        step = newton_iteration(model, motion, masses, work, negate(done), LIMITS)
        negative = where(done, negative, step.negative_pivots)
        done = done | step.converged
        failed = failed | step.failed
        if not any_true(negate(done | failed)):
            break
    return negative, negate(done)
