"""One Newton iteration of every lane: assemble, solve, keep every gap open, step."""

from typing import Any, NamedTuple

from snapjump.contact.base import Extremes
from snapjump.discretization.base import NODES_COUPLED
from snapjump.engine.assemble import Motion, add_node, assemble_nodes, begin_assembly, end_assembly
from snapjump.engine.clock import BACKTRACKS, FASTEST, GAP, ITERATION, RESIDUAL, SHARE, SIZE
from snapjump.engine.gaps import gap_safe_share
from snapjump.engine.sticking import settles_sliding, unsettled_sliding
from snapjump.linear_solver.banded import (
    Elimination,
    begin_elimination,
    eliminate_columns,
    eliminate_node,
    substitute_back,
)
from snapjump.linear_solver.banded_rotations import (
    eliminate_rotating_node,
    substitute_back_rotating,
)
from snapjump.linear_solver.contact_rows import NodeRows
from snapjump.number.array import own_rows
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, any_true, maximum, minimum, negate, where

# Rate of convergence that a stage's first iteration is credited with: its guess follows the motion.
# Measured rates of jumps lie below.
FIRST_RATE = 0.1
GROWTH_LIMIT = 2.0  # of the correction, above which the last one is halved
LARGEST_CORRECTION = 0.3  # of the beam's length
ROUNDING = 2.0**-50  # of the length: what rounding of a point's few coordinates adds up to
LARGEST_SHAKE = 1e-6  # of the length: corrections beyond are more than rounding
SHRINKING = 0.5  # of the last correction: a smaller one still converges


ENDS = NODES_COUPLED + 1  # nodes at either end whose columns a clamp's own node reaches


class Allowed(NamedTuple):
    """What an iteration may leave: an error (L), and of a foot's sliding a share of the speed below
    which friction sticks."""

    error: Any
    stick_share: Any


class Correction(NamedTuple):
    """Of an iteration: masks of the lanes that have converged and that have failed, and how many
    pivots are not positive."""

    converged: Any
    failed: Any
    negative_pivots: Any


@kernel
def largest_of(values: Any, count: Any, largest: Any) -> Any:
    """The largest absolute value of the first few, or ``largest`` if that is larger."""
    for k in range(count):
        largest = maximum(largest, absolute(values[k]))
    return largest


class Solution(NamedTuple):
    """Figures of a solved work: those of its assembly, the largest residual (EI/L^2) and
    correction (L), and the number of pivots that are not positive."""

    extremes: Extremes
    residual: Any
    correction: Any
    negative_pivots: Any


@routine
def eliminate_nodes(
    work: Any, rotations: Any, bordered: Any, first: Any, end: Any, done: Elimination
) -> Elimination:
    """Eliminate nodes from ``first`` up to ``end``, which stand in memory."""
    for node in range(first, end):
        if rotations:
            done = eliminate_rotating_node(work, node, bordered, done)
        else:
            done = eliminate_node(work, node, bordered, done)
    return done


@routine
def solve_linearised(model: Any, motion: Motion, masses: Any, work: Any) -> Solution:
    """Assemble the system and solve it, node by node, in one sweep and back.

    A node is eliminated as soon as it is complete. Three nodes at either end, which the clamps
    reach, pass through memory; those between have rows that go no further than registers.
    """
    dofs = model.frame.dofs(work.mesh)
    bordered = model.frame.border_width() > 0
    rotations = model.discretization.node_dofs() == 3
    nodes = masses.shape[0]
    begin = min(ENDS, nodes)
    end = max(begin, nodes - ENDS)
    if rotations or nodes < 2 * ENDS:
        begin = end = nodes
    zero = 0.0 * motion.rate_factor
    sweep = begin_assembly(model, motion, masses, work)
    sweep = assemble_nodes(model, motion, masses, work, 0, begin, sweep)
    done = eliminate_nodes(work, rotations, bordered, 0, begin, begin_elimination(zero))
    if not rotations:
        nothing = ((zero, zero, zero), (zero, zero, zero))
        rows = NodeRows(*own_rows(zero), 0)
        for node in range(begin, end):
            sweep = add_node(model, motion, masses, work, node, 2, sweep, rows)
            done = eliminate_columns(work, node, rows, nothing, bordered, done)
    sweep = assemble_nodes(model, motion, masses, work, end, nodes, sweep)
    done = eliminate_nodes(work, rotations, bordered, end, nodes, done)
    remaining = done.largest
    negative = done.negative
    correction = zero
    if bordered:
        remaining = largest_of(work.frame_residual, dofs, remaining)
        negative = negative + model.frame.solve(work, done)
        correction = largest_of(work.frame_residual, dofs, correction)
    remains = model.frame.border_width() == 3
    if rotations:
        correction = maximum(correction, substitute_back_rotating(work, remains, zero))
    else:
        correction = maximum(correction, substitute_back(work, remains, zero))
    return Solution(end_assembly(sweep), remaining, correction, negative)


@routine
def newton_iteration(
    model: Any,
    motion: Motion,
    masses: Any,
    work: Any,
    mask: Any,
    allowed: Allowed,
    most_iterations: Any,
    most_backtracks: Any,
) -> Correction:
    """Correct ``work.state`` in the masked lanes; what is returned of the others is void."""
    clock = work.clock
    size = work.state.shape[0]
    dofs = model.frame.dofs(work.mesh)
    tiny = 1e-300 + 0.0 * motion.rate_factor
    x = work.residual
    y = work.frame_residual
    solution = solve_linearised(model, motion, masses, work)
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
    back = grew & (clock[BACKTRACKS] < most_backtracks) & finite & mask
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
    exact = (rate * correction <= allowed.error) | shaken
    if settles_sliding(model):
        if any_true(exact & mask):
            left = rate * unsettled_sliding(model, motion.rate_factor, masses, work)
            exact = exact & (left <= allowed.stick_share * model.friction.stick_speed())
    converged = exact & (share >= 1.0) & negate(back) & finite
    iteration = clock[ITERATION] + 1.0
    failed = (iteration >= most_iterations) & negate(converged) | negate(finite)
    clock[ITERATION] = iteration
    clock[SIZE] = where(back, clock[SIZE], correction)
    clock[SHARE] = where(back, half, share)
    clock[BACKTRACKS] = clock[BACKTRACKS] + where(back, 1.0, 0.0)
    return Correction(converged, failed, solution.negative_pivots)
