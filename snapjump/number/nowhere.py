"""An array that keeps nothing: what is written to it is not even computed.

An assembly whose matrix goes nowhere compiles to one of the residual alone.
"""

import operator
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic, models, overload, register_model

from snapjump.number.dispatch import INLINED


class NowhereType(types.Type):
    """The type of an array that forgets every entry; read, all are zero, and its parts like it."""

    def __init__(self) -> None:
        super().__init__(name="Nowhere")


@register_model(NowhereType)
class NowhereModel(models.OpaqueModel):
    """Nothing at all."""


NOWHERE = NowhereType()


@infer_global(operator.getitem)
class _Reading(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        if args[0] is not NOWHERE:
            return None
        return signature(NOWHERE if isinstance(args[1], types.SliceType) else types.float64, *args)


@infer_global(operator.setitem)
class _Writing(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(types.none, *args) if args[0] is NOWHERE else None


@lower_builtin(operator.getitem, NowhereType, types.Any)
def _read(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    if sig.return_type is NOWHERE:
        return context.get_dummy_value()
    return ir.Constant(ir.DoubleType(), 0.0)


@lower_builtin(operator.setitem, NowhereType, types.Any, types.Any)
def _write(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return context.get_dummy_value()


class Nowhere:
    """The same in plain Python."""

    def __getitem__(self, index: Any) -> Any:
        return self if isinstance(index, slice) else 0.0

    def __setitem__(self, index: Any, value: Any) -> None:
        pass


def nowhere() -> Any:
    """An array that keeps nothing."""
    return Nowhere()


def keeps(array: Any) -> Any:
    """Whether an array keeps what is written to it; a constant while compiling."""
    return not isinstance(array, Nowhere)


@overload(keeps, strict=False, jit_options=INLINED)
def _keeps(array: Any) -> Any:
    kept = array is not NOWHERE
    return lambda array: kept


@intrinsic
def _nowhere(typingctx: Any) -> Any:
    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return context.get_dummy_value()

    return NOWHERE(), codegen


@overload(nowhere, strict=False, jit_options=INLINED)
def _nowhere_in_kernels() -> Any:
    return lambda: _nowhere()
