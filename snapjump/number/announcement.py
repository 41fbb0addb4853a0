"""Telling the user when kernels are compiled: once after installation, and it takes a while."""

import threading
from typing import Any

from snapjump.files.notice import notice
from snapjump.number.once import one_process_compiles

TYPICAL_SECONDS = 15
PATIENCE_SECONDS = 2.0  # longer than loading a compiled kernel from disk takes


def load(kernel: Any, *args: Any, typical_seconds: int = TYPICAL_SECONDS) -> None:
    """Call a numba function, announcing on stderr that it is being compiled if that takes time.

    Of several processes that need it one compiles, and the others wait for that.
    Meant for a first call that does no work, so that compilation is not timed as simulation.
    """
    before = len(kernel.signatures)

    def announce() -> None:
        if len(kernel.signatures) == before:
            notice(f"compiling kernels, once, about {typical_seconds} s ...")

    timer = threading.Timer(PATIENCE_SECONDS, announce)
    timer.daemon = True
    timer.start()
    try:
        with one_process_compiles(kernel, *args):
            kernel(*args)
    finally:
        timer.cancel()
