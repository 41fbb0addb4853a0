"""Compiling for the card so that it rounds as the processor does.

NVIDIA's compiler merges a product and a sum into one rounding wherever it can. The engine says
itself where (:func:`snapjump.number.functions.fma`), so that every program compiled from it gives
the same bits; numba-cuda hands that switch to the compiler but does not offer it to its callers.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial

from snapjump.engine.cuda.availability import simulated


@contextmanager
def rounded_as_written() -> Iterator[None]:
    """A context in which programs are compiled without such merging."""
    if simulated():
        yield
        return
    from numba.cuda.cudadrv import nvvm

    compile_ir = nvvm.compile_ir
    nvvm.compile_ir = partial(compile_ir, fma=False)
    try:
        yield
    finally:
        nvvm.compile_ir = compile_ir
