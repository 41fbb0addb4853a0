"""Compiling a kernel and what it calls as one program, instead of each function for itself.

numba optimises every function, with all that it calls, and makes machine code of it, before it
links it into its caller, where all this happens once more. Functions that only kernels call need
neither: they are *parts*, each simplified by itself, until a *program*, a function that Python
calls, links, optimises and translates all its parts at once. Compiling takes less time so; what
the program computes is the same to the last bit. (Parts that are kept as numba wrote them make
slower programs, by a tenth for one robot, and compiling is no faster.)

This builds on numba's :class:`JITCodeLibrary`, whose insides may change with its minor version.
"""

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import InlineOverloads, NativeLowering, NopythonRewrites
from numba.core.untyped_passes import InlineInlinables, WithLifting

# What no kernel has: "with" blocks, functions that are inlined as Python, expressions of whole
# arrays. Looking for them takes a fifteenth of the time.
LEFT_OUT = (WithLifting, InlineInlinables, InlineOverloads, NopythonRewrites)
MANGLED = "_ZN"  # how names of compiled Python functions begin


class Part(JITCodeLibrary):
    """The code of one function, simplified by itself, but not linked with what it calls."""

    _linked: Any = None

    def finalize(self) -> None:
        """Nothing is left to do but in the program."""
        self._finalized = True

    def own_module(self) -> Any:
        """The function itself, for programs to link."""
        return super()._get_module_for_linking()

    def _get_module_for_linking(self) -> Any:
        """The function and all that it calls, for numba's own functions that call parts."""
        if self._linked is None:
            self._linked = self.own_module().clone()
            link_calls(self, self._linked)
        return self._linked

    def get_pointer_to_function(self, name: str) -> int:
        """Null: Python never calls a part."""
        return 0

    @property
    def codegen(self) -> Any:
        """What sets a function's environment, of which a part that Python never calls has none."""
        return self

    def set_env(self, name: str, env: Any) -> None:
        """Nothing to set."""


class Program(JITCodeLibrary):
    """A function that Python calls, and all that it calls."""

    def finalize(self) -> None:
        """Link the parts, optimise, translate."""
        link_calls(self, self._final_module)
        self._linking_libraries.clear()
        functions = self._final_module.functions
        missing = [f.name for f in functions if f.is_declaration and f.name.startswith(MANGLED)]
        if missing:
            raise RuntimeError(f"{self.name} calls what was not linked: {', '.join(missing)}")
        super().finalize()


def link_calls(library: JITCodeLibrary, module: Any) -> None:
    """Link into a module all that its library calls, directly or not."""
    parts = callers_first(library)
    others = [
        callee
        for caller in (library, *parts)
        for callee in caller._linking_libraries
        if not isinstance(callee, Part)
    ]
    for part in parts:
        module.link_in(part.own_module(), preserve=True)
    for other in dict.fromkeys(others):
        module.link_in(other._get_module_for_linking(), preserve=True)
    for callee in (*parts, *others):
        library._reload_init.update(callee._reload_init)


def callers_first(library: JITCodeLibrary) -> list[Part]:
    """All parts that a library calls, each after all its callers.

    LLVM drops functions that nothing calls when they are linked.
    """
    seen, order = set(), []

    def visit(caller: Any) -> None:
        for callee in caller._linking_libraries:
            if isinstance(callee, Part) and callee not in seen:
                seen.add(callee)
                visit(callee)
                order.append(callee)

    visit(library)
    return order[::-1]


class KernelLower(Lower):
    """Writes a function's code, and counts references only in types that have some to count.

    numba takes every tuple apart to look for them, whenever a variable is set or dropped.
    """

    def incref(self, typ: Any, val: Any) -> None:
        if self._counts(typ):
            super().incref(typ, val)

    def decref(self, typ: Any, val: Any) -> None:
        if self._counts(typ):
            super().decref(typ, val)

    def _counts(self, kind: Any) -> bool:
        return bool(self.context.data_model_manager[kind].contains_nrt_meminfo())


@contextmanager
def little_garbage() -> Iterator[None]:
    """Look for garbage less often: among all objects of a compiler it takes a tenth of the time."""
    usual = gc.get_threshold()
    gc.set_threshold(100_000, 50, 100)
    try:
        yield
    finally:
        gc.set_threshold(*usual)


def compiler(library: type[JITCodeLibrary]) -> type[CompilerBase]:
    """numba's compiler, for code that is kept in such a library."""

    @register_pass(mutates_CFG=True, analysis_only=False)
    class Lowering(NativeLowering):
        _name = f"native_lowering_of_a_{library.__name__.lower()}"
        lowering_class = KernelLower

        def run_pass(self, state: Any) -> bool:
            state.library = library(state.targetctx.codegen(), state.func_id.func_qualname)
            state.library.enable_object_caching()
            return super().run_pass(state)

    class Compiler(CompilerBase):
        def compile_extra(self, func: Any) -> Any:
            with little_garbage():
                return super().compile_extra(func)

        def define_pipelines(self) -> list[Any]:
            passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
            passes.passes = [
                (Lowering if kind is NativeLowering else kind, words)
                for kind, words in passes.passes
                if kind not in LEFT_OUT
            ]
            return [passes]

    return Compiler


PartCompiler = compiler(Part)
ProgramCompiler = compiler(Program)
