"""The memory of a march seen as arrays of numbers."""

from typing import Any

from snapjump.engine.work import System, Work
from snapjump.number.array import uncounted
from snapjump.number.dispatch import routine
from snapjump.number.lane import view_numbers


@routine
def view_work(work: Any, lanes: Any) -> Work:
    """The memory as arrays of numbers, one lane or many."""
    system = System(
        view_numbers(work.system.residual, lanes),
        view_numbers(work.system.band, lanes),
        view_numbers(work.system.border, lanes),
        view_numbers(work.system.padded_residual, lanes),
        view_numbers(work.system.padded_band, lanes),
        view_numbers(work.system.padded_border, lanes),
        view_numbers(work.system.frame_residual, lanes),
        view_numbers(work.system.square, lanes),
        view_numbers(work.system.mounts, lanes),
        view_numbers(work.system.padded_frame_residual, lanes),
        view_numbers(work.system.frame_band, lanes),
        view_numbers(work.system.frame_border, lanes),
        view_numbers(work.system.levers, lanes),
        view_numbers(work.system.last_residual, lanes),
        view_numbers(work.system.last_square, lanes),
    )
    return Work(
        view_numbers(work.state, lanes),
        view_numbers(work.start, lanes),
        view_numbers(work.origin, lanes),
        view_numbers(work.drift, lanes),
        view_numbers(work.change, lanes),
        view_numbers(work.velocity, lanes),
        view_numbers(work.acceleration, lanes),
        view_numbers(work.sliding_velocity, lanes),
        view_numbers(work.active_set, lanes),
        view_numbers(work.clock, lanes),
        view_numbers(work.numbers, lanes),
        view_numbers(work.weights, lanes),
        uncounted(work.mesh),
        system,
    )
