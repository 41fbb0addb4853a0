"""Kernel functions chosen by the class of their first argument, in Python and in numba alike.

A member of a family (a contact law, say) is a ``NamedTuple`` of numbers. A family declares a
function once with :func:`family_function`; each member registers its own version. numba resolves
the call while it compiles, so that a choice costs nothing at run time.
"""

import functools
from collections.abc import Callable
from typing import Any

from numba import njit
from numba.extending import overload, register_jitable

from snapjump.number.linking import PartCompiler, ProgramCompiler

Function = Callable[..., Any]


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


def member_class(kind: Any) -> Any:
    """The Python class behind a numba named-tuple type, or the type itself."""
    return getattr(kind, "instance_class", kind)


def family_function(declaration: Function) -> Any:
    """Turn a declaration (docstring and arguments) into a function with one version a member."""
    versions: dict[Any, Function] = {}

    @functools.wraps(declaration)
    def call(member: Any, *args: Any) -> Any:
        return versions[type(member)](member, *args)

    def member(cls: type) -> Callable[[Function], Function]:
        """Register the decorated function as the version for members of class ``cls``."""

        def register(function: Function) -> Function:
            shared = function in versions.values()  # by several members
            versions[cls] = function if shared else kernel(function)
            return function

        return register

    call.member = member  # type: ignore[attr-defined]
    call.versions = versions  # type: ignore[attr-defined]

    @overload(call, strict=False, jit_options=INLINED)
    def _resolve(member: Any, *args: Any) -> Any:
        return versions.get(member_class(member))

    return call
