"""Counters that threads share."""

from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic, overload

from snapjump.number.dispatch import INLINED


def fetch_add(counters: Any, index: Any, amount: Any) -> Any:
    """Add to an element of an array of integers and return what it was before.

    In compiled code that is one indivisible step: no two threads are returned the same number.
    """
    before = int(counters[index])
    counters[index] = before + amount
    return before


@intrinsic
def _atomic_add(typingctx: Any, counters: Any, index: Any, amount: Any) -> Any:
    number = counters.dtype

    def codegen(context: Any, builder: ir.IRBuilder, sig: Any, args: Any) -> Any:
        data = context.make_array(sig.args[0])(context, builder, args[0]).data
        place = context.cast(builder, args[1], sig.args[1], types.intp)
        value = context.cast(builder, args[2], sig.args[2], number)
        return builder.atomic_rmw("add", builder.gep(data, [place]), value, "seq_cst")

    return number(counters, index, amount), codegen


@overload(fetch_add, strict=False, jit_options=INLINED)
def _fetch_add(counters: Any, index: Any, amount: Any) -> Any:
    if isinstance(counters, types.Array) and isinstance(counters.dtype, types.Integer):
        return lambda counters, index, amount: _atomic_add(counters, index, amount)
    return None
