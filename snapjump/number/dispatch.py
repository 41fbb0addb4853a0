"""How kernels are compiled: what Python calls, what only they call, and what is merged."""

from numba import njit
from numba.extending import register_jitable

from snapjump.number.linking import PartCompiler, ProgramCompiler

# Plain Python functions that compiled code may call: small ones are merged into their callers
# (lanes travel through memory across a call), large ones are compiled once a program.
# No C code calls them, so that numba need not compile a door for it.
COMPILED = {"no_cfunc_wrapper": True, "pipeline_class": PartCompiler}
INLINED = {"forceinline": True, **COMPILED}
kernel = register_jitable(**INLINED)
routine = register_jitable(**COMPILED)
# A function that Python calls, compiled for its arguments once and kept on disk; threads may call
# one that is released.
PROGRAM = {"cache": True, "error_model": "numpy", "pipeline_class": ProgramCompiler}
compiled = njit(**PROGRAM)
released = njit(nogil=True, **PROGRAM)
