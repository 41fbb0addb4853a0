"""Pieces of a pass of the time loop, repeated on a state that does not move.

Each is compiled by itself, so that the time of a part is a difference: of contact, for example,
that of the assembly with it and without.
"""

from typing import Any

from numba import njit

from snapjump.engine.assemble import assemble
from snapjump.engine.clock import TIME
from snapjump.engine.model import with_numbers
from snapjump.engine.newton import newton_iteration, solve_linearised
from snapjump.engine.stage import stage_motion
from snapjump.engine.view import view_work

TOLERANCE, MOST_ITERATIONS, MOST_BACKTRACKS = 1e-9, 25.0, 4.0


@njit(cache=True, error_model="numpy")
def assemble_often(
    template: Any, masses: Any, scheme: Any, memory: Any, lanes: Any, count: int
) -> None:
    """Residual and tangent, node by node."""
    work = view_work(memory, lanes)
    model = with_numbers(template, work.numbers)
    motion = stage_motion(scheme, work)
    for _ in range(count):
        assemble(model, motion, masses, work)


@njit(cache=True, error_model="numpy")
def solve_often(
    template: Any, masses: Any, scheme: Any, memory: Any, lanes: Any, count: int
) -> None:
    """The same and the solution of the linear system."""
    work = view_work(memory, lanes)
    model = with_numbers(template, work.numbers)
    motion = stage_motion(scheme, work)
    for _ in range(count):
        solve_linearised(model, motion, masses, work)


@njit(cache=True, error_model="numpy")
def iterate_often(
    template: Any, masses: Any, scheme: Any, memory: Any, lanes: Any, count: int
) -> None:
    """A whole Newton iteration, of which no lane takes the correction."""
    work = view_work(memory, lanes)
    model = with_numbers(template, work.numbers)
    motion = stage_motion(scheme, work)
    nobody = work.clock[TIME] < -1.0
    for _ in range(count):
        newton_iteration(
            model, motion, masses, work, nobody, TOLERANCE, MOST_ITERATIONS, MOST_BACKTRACKS
        )
