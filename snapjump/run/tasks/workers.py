"""Worker processes of a parallel sweep: they end when the process that began it has gone."""

import os
import signal
import threading
import time
from functools import cache

LOOK_EVERY_S = 0.5
GRACE_S = 5.0  # in which a cell that is stopped leaves a marked run


# The process that runs a sweep; its workers inherit it.
SWEEP_PROCESS = "SNAPJUMP_SWEEP_PROCESS"


@cache
def end_with_sweep() -> None:
    """Watch the process of the sweep, if this is a worker that it has started; once is enough."""
    parent = os.getppid()
    if os.environ.get(SWEEP_PROCESS) == str(parent):
        threading.Thread(target=_watch, args=(parent,), daemon=True).start()


def _watch(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(LOOK_EVERY_S)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE_S)
    os._exit(1)  # on to the next cell of a sweep that nobody is waiting for, otherwise
