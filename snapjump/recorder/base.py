"""Recorders of a march: the contract that every one fulfils.

They are chosen by class, so that a march without one is compiled without any trace of them.
"""

from typing import Any

from snapjump.number.dispatch import family_function


@family_function
def record_robot(recorder: Any, lane: Any, robot: Any) -> None:
    """Called when a lane has been given a robot of the queue."""


@family_function
def record_start(recorder: Any, model: Any, masses: Any, work: Any) -> None:
    """Called once before the first step."""


@family_function
def record_stage(
    recorder: Any, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
) -> None:
    """Called when stages have converged, before the clock's stage moves on."""


@family_function
def record_step(recorder: Any, scheme: Any, work: Any, good: Any) -> None:
    """Called when steps have been judged; ``good`` is the mask of those that stand, committed."""


@family_function
def record_end(recorder: Any, model: Any, masses: Any, lane: Any, robot: Any) -> None:
    """Called when a robot is about to leave its lane."""
