"""Recorders of a march: the contract that every one fulfils.

They are chosen by class, so that a march without one is compiled without any trace of them.
"""

from typing import Any

from snapjump.number.dispatch import family_function


@family_function
def record_start(recorder: Any, model: Any, masses: Any, work: Any) -> None:
    """Called once before the first step."""


@family_function
def record_stage(
    recorder: Any, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
) -> None:
    """Called when stages have converged, before the clock's stage moves on."""


@family_function
def record_step(recorder: Any, work: Any) -> None:
    """Called when a step has been judged and, if it stands, committed."""
