"""Compiling once, however many processes need the same kernel at the same time."""

import fcntl
import hashlib
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from typing import Any

from numba.core.dispatcher import Dispatcher

from snapjump.number.compile_cache import folder_in_use


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
    with ExitStack() as held:
        # Where files cannot be written or locked, each process compiles for itself.
        with suppress(OSError):
            folder = folder_in_use() / "compiling"
            folder.mkdir(parents=True, exist_ok=True)
            file = held.enter_context(open(folder / program, "a"))
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def types_of(kernel: Any, args: Any) -> Any:
    """The signature that numba chooses a program by; None for what is no function of numba's."""
    if not isinstance(kernel, Dispatcher):
        return None
    return tuple(kernel.typeof_pyval(arg) for arg in args)
