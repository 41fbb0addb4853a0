"""Compiling once, however many processes need the same kernel at the same time."""

import hashlib
import os
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from typing import Any

from numba.core.dispatcher import Dispatcher

from snapjump.files.flock import lock_file
from snapjump.number.announcement import announce
from snapjump.number.compile_cache import KernelCache, folder_in_use


def load(kernel: Any, *args: Any) -> None:
    """Have a numba function compiled for these arguments, or fetched from disk.

    Of several processes that need it one compiles, and the others wait for that. The arguments
    give it nothing to do, so that compiling is not timed as simulation.
    """
    if isinstance(kernel, Dispatcher) and types_of(kernel, args) in kernel.overloads:
        return
    with one_process_compiles(kernel, *args):
        kernel(*args)


@contextmanager
def one_process_compiles(kernel: Any, *args: Any) -> Iterator[None]:
    """Keep others from compiling what a first call in the block would compile.

    They wait, and then find it among the kernels on disk. Who needs another program does not wait.
    """
    if not isinstance(kernel, Dispatcher):
        yield
        return
    kinds = types_of(kernel, args)
    program = hashlib.sha256(repr((kernel.__qualname__, kinds)).encode()).hexdigest()[:16]
    with ExitStack() as held:
        # Where files cannot be written or locked, each process compiles for itself.
        with suppress(OSError):
            folder = folder_in_use() / "compiling"
            folder.mkdir(parents=True, exist_ok=True)
            file = held.enter_context(open(folder / program, "a"))
            try:
                lock_file(file, wait=False)
            except BlockingIOError:
                announce(kernel.__name__, waiting=True)
                lock_file(file)
        yield


def types_of(kernel: Dispatcher, args: Any) -> tuple[Any, ...]:
    """The signature that numba chooses a program by."""
    return tuple(kernel.typeof_pyval(arg) for arg in args)


def would_compile(kernel: Dispatcher, args: Any) -> bool:
    """Whether a call has to compile, and can keep what it compiles for other processes."""
    cache, kinds = kernel._cache, types_of(kernel, args)
    if kinds in kernel.overloads or not isinstance(cache, KernelCache):
        return False
    return os.access(folder_in_use(), os.W_OK) and not cache.holds(kinds, kernel.targetctx)
