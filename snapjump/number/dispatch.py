"""Decorators of kernels: programs that Python calls, routines, and what is inlined."""

from collections.abc import Callable
from typing import Any

from numba import njit
from numba.extending import register_jitable

from snapjump.files import sources
from snapjump.number.compile_cache import kernel_cache, use_cache_folder
from snapjump.number.linking import PartCompiler, ProgramCompiler

# Plain Python functions that compiled code may call: small ones are merged into their callers
# (lanes travel through memory across a call), large ones are compiled once a program.
# No C code calls them, so that numba need not compile a door for it.
COMPILED = {"no_cfunc_wrapper": True, "pipeline_class": PartCompiler}
INLINED = {"forceinline": True, **COMPILED}
kernel = register_jitable(**INLINED)
routine = register_jitable(**COMPILED)
# A function that Python calls, compiled for its arguments once and kept on disk.
PROGRAM = {"error_model": "numpy", "pipeline_class": ProgramCompiler}
_programs: list[Any] = []


def compiled(function: Callable[..., Any]) -> Any:
    """A program: what Python calls."""
    return _remembered(njit(**PROGRAM)(function))


def released(function: Callable[..., Any]) -> Any:
    """A program that several threads may call at the same time."""
    return _remembered(njit(nogil=True, **PROGRAM)(function))


def refresh() -> None:
    """Keep programs in the folder of the sources with the plug-ins that there are now.

    What has been compiled before stays in this process, and on disk where it was.
    """
    for folder in sources.PLUGINS:
        sources.forget(folder)
    use_cache_folder()
    for program in _programs:
        program._cache = kernel_cache(program.py_func)


def _remembered(program: Any) -> Any:
    program._cache = kernel_cache(program.py_func)
    _programs.append(program)
    return program
