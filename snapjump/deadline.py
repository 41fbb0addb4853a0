"""Waiting with an end: work of others that may never answer, in a thread that is left behind."""

import threading
import time
from collections.abc import Callable
from typing import Any, TypeVar

T = TypeVar("T")
LOOK_S = 0.1


class LateError(TimeoutError):
    """Nothing came of it in time."""


class Worker(threading.Thread):
    """Does one piece of work. ``left``: nobody waits for it any more, and it should stop."""

    def __init__(self, work: Callable[[], Any]):
        super().__init__(daemon=True)
        self._work = work
        self.left = False
        self.done = threading.Event()
        self.result: Any = None
        self.error: BaseException | None = None

    def run(self) -> None:
        try:
            self.result = self._work()
        except BaseException as error:
            self.error = error
        self.done.set()


def within(seconds: float, work: Callable[[], T]) -> T:
    """What comes of the work. Raises what it raises, :class:`LateError` after so many seconds, and
    KeyboardInterrupt at once."""
    worker = Worker(work)
    worker.start()
    end = time.monotonic() + seconds
    try:
        # In short waits: a signal that another thread is given does not end one.
        while not worker.done.wait(LOOK_S):
            if time.monotonic() > end:
                raise LateError(f"no answer within {seconds:.3g} s")
    finally:
        worker.left = True
    if worker.error is not None:
        raise worker.error
    found: T = worker.result
    return found


def check_left() -> None:
    """Raise :class:`LateError` in a thread that nobody waits for any more: between two requests."""
    if getattr(threading.current_thread(), "left", False):
        raise LateError("nobody waits for it any more")
