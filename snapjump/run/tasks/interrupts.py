"""Ctrl-C while a job is done: heeded, but never halfway through its files."""

import signal
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import Any

from snapjump.run.tasks.base import Progress


def heeded() -> AbstractContextManager[list[int]]:
    """Let Ctrl-C stop the block, at its end if need be: raised inside a callback of a library,
    KeyboardInterrupt may be swallowed there. Gives the signals that have come."""
    return _noticed(at_once=True)


def uninterrupted() -> AbstractContextManager[list[int]]:
    """Put off Ctrl-C until the block is through, so that a run is never marked halfway."""
    return _noticed(at_once=False)


def stopping(progress: Progress, noticed: list[int]) -> Progress:
    """The progress of a task that Ctrl-C stops when it is told next, if it was swallowed."""

    def tell(done: float, text: str) -> None:
        if noticed:
            raise KeyboardInterrupt
        progress(done, text)

    return tell


@contextmanager
def _noticed(at_once: bool) -> Iterator[list[int]]:
    """Note Ctrl-C, and raise KeyboardInterrupt at the end of the block, or before as well."""
    noticed: list[int] = []
    if threading.current_thread() is not threading.main_thread():
        yield noticed
        return

    def note(number: int, frame: Any) -> None:
        noticed.append(number)
        if at_once:
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGINT, note)
    try:
        yield noticed
    finally:
        signal.signal(signal.SIGINT, before)
    if noticed:
        raise KeyboardInterrupt
