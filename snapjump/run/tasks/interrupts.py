"""Ctrl-C, SIGTERM and SIGHUP while a job is done: heeded, but never halfway through its files."""

import signal
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import Any

from snapjump.run.tasks.base import Progress

# What stops a job: the user, the system that runs it (SLURM, docker), a terminal that goes away,
# which Windows tells of in other ways.
NAMES = ("SIGINT", "SIGTERM", "SIGHUP")
SIGNALS = [getattr(signal, name) for name in NAMES if hasattr(signal, name)]


def heeded() -> AbstractContextManager[list[int]]:
    """Let a signal stop the block as Ctrl-C does, at its end if need be: raised inside a callback
    of a library, KeyboardInterrupt may be swallowed there. Gives the signals that have come."""
    return _noticed(at_once=True)


def uninterrupted() -> AbstractContextManager[list[int]]:
    """Put off signals until the block is through, so that a run is never marked halfway."""
    return _noticed(at_once=False)


def stopping(progress: Progress, noticed: list[int]) -> Progress:
    """The progress of a task that Ctrl-C stops when it is told next, if it was swallowed."""

    def tell(done: float, text: str) -> None:
        if noticed:
            raise KeyboardInterrupt
        progress(done, text)

    return tell


def reason(noticed: list[int]) -> str:
    """Who stopped a job, in words."""
    others = [signal.Signals(number).name for number in noticed if number != signal.SIGINT]
    return f"stopped by {others[0]}" if others else "interrupted by the user"


@contextmanager
def _noticed(at_once: bool) -> Iterator[list[int]]:
    """Note signals, and raise KeyboardInterrupt at the end of the block, or before as well."""
    noticed: list[int] = []
    if threading.current_thread() is not threading.main_thread():
        yield noticed
        return

    def note(number: int, frame: Any) -> None:
        noticed.append(number)
        if at_once:
            raise KeyboardInterrupt

    # What nohup has made a process ignore, it goes on ignoring.
    heard = [number for number in SIGNALS if signal.getsignal(number) != signal.SIG_IGN]
    before = {number: signal.signal(number, note) for number in heard}
    try:
        yield noticed
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if noticed:
        raise KeyboardInterrupt
