"""Compiling once, however many processes need the same kernel at the same time."""

import fcntl
import hashlib
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numba
from numba.core.dispatcher import Dispatcher


@contextmanager
def one_process_compiles(kernel: Any, *args: Any) -> Iterator[None]:
    """Keep others from compiling what a first call in the block would compile.

    They wait, and then find it among the kernels on disk. Who needs another program does not wait.
    """
    kinds = types_of(kernel, args)
    if kinds is None or kinds in kernel.overloads:
        yield
        return
    program = hashlib.sha256(repr((kernel.__qualname__, kinds)).encode()).hexdigest()[:16]
    folder = Path(numba.config.CACHE_DIR) / "compiling"
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / program, "a") as file:
        # Where files cannot be locked, each process compiles for itself.
        with suppress(OSError):
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def types_of(kernel: Any, args: Any) -> Any:
    """The signature that numba chooses a program by; None for what is no function of numba's."""
    if not isinstance(kernel, Dispatcher):
        return None
    return tuple(kernel.typeof_pyval(arg) for arg in args)
