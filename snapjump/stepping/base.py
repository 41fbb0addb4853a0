"""Step control: the contract that every member fulfils (a ``NamedTuple`` of numbers)."""

from typing import Any

from snapjump.number.dispatch import family_function


@family_function
def first_step(stepping: Any) -> Any:
    """Size of the first step (T)."""


@family_function
def accepts(stepping: Any, error: Any, step: Any, contact_rate: Any) -> Any:
    """Whether a step stands, given its error estimate (L) and the fastest contact frequency."""


@family_function
def next_step(stepping: Any, error: Any, error_order: Any, step: Any, contact_rate: Any) -> Any:
    """Size of the next step, or of the repetition of a refused one (T)."""


@family_function
def step_after_failure(stepping: Any, step: Any) -> Any:
    """Size of the repetition after Newton's method failed (T)."""


@family_function
def smallest_step(stepping: Any) -> Any:
    """Below this (T) a march ends with the status step_underflow."""


@family_function
def newton_tolerance(stepping: Any) -> Any:
    """Error (L) that Newton's method may leave in a stage."""
