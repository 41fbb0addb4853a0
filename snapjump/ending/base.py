"""When a march ends: the contract that every ending fulfils (a ``NamedTuple`` of numbers)."""

from typing import Any

from snapjump.number.dispatch import family_function


@family_function
def time_limit(ending: Any) -> Any:
    """No step goes beyond this time (T)."""


@family_function
def leniency(ending: Any, model: Any, work: Any) -> Any:
    """Factor (at least 1) by which a step's error may exceed the tolerance: what can no longer
    change the result need not be resolved."""


@family_function
def judge(ending: Any, model: Any, masses: Any, work: Any, ended: Any) -> Any:
    """Status (:mod:`snapjump.engine.status`) after an accepted step, 0 to go on."""
