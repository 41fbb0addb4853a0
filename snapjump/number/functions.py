"""Functions of one number that work on Python numbers, numba scalars and lanes.

In plain Python they also take complex numbers, so that tests can differentiate by a complex step,
and arrays, for what is read off many robots.
"""

import cmath
import math
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.extending import intrinsic, overload

from snapjump.number.dispatch import INLINED
from snapjump.number.dual import dual, slopes_of, times, value_of
from snapjump.number.dual_type import DualType, Parts, dual_type, repeated, scaled_onto, together
from snapjump.number.lane import LaneType, MaskType, lane_type, splat, vector_intrinsic


def _scalar_function(module: ir.Module, name: str) -> ir.Function:
    """A function of one double: LLVM's intrinsic, or CUDA's own library where that runs."""
    double = ir.DoubleType()
    if module.triple.startswith("nvptx"):
        kind = ir.FunctionType(double, [double])
        return cgutils.get_or_insert_function(module, kind, f"__nv_{name}")
    return module.declare_intrinsic(f"llvm.{name}", [double])


def is_plain(*kinds: types.Type) -> bool:
    """Whether these are numbers or lanes of them, and nothing that carries derivatives."""
    return all(isinstance(kind, (LaneType, types.Float, types.Integer)) for kind in kinds)


def _elementwise(name: str, in_python: Any, of_dual: Any) -> Any:
    """A function of one number: ``llvm.<name>`` in numba, ``in_python`` outside it.

    ``of_dual``: the function of a dual, given that of its value.
    """

    def function(x: Any) -> Any:
        return in_python(x)

    function.__name__ = function.__qualname__ = name

    @intrinsic
    def of_number(typingctx: Any, x: Any) -> Any:
        kind = x if isinstance(x, LaneType) else types.float64

        def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            value = context.cast(builder, args[0], sig.args[0], kind)
            if isinstance(kind, LaneType):
                return vector_intrinsic(builder, name, value)
            return builder.call(_scalar_function(builder.module, name), [value])

        return kind(x), codegen

    @overload(function, strict=False, jit_options=INLINED)
    def _in_numba(x: Any) -> Any:
        if isinstance(x, DualType):
            return of_dual(of_number)
        return (lambda x: of_number(x)) if is_plain(x) else None

    return function


def _sqrt_of_dual(root: Any) -> Any:
    def differentiated(x: Any) -> Any:
        value = root(value_of(x))
        return dual(value, times(slopes_of(x), 0.5 / value))

    return differentiated


def _nearest_of_dual(rounded: Any) -> Any:
    return lambda x: rounded(value_of(x))


def _absolute_of_dual(magnitude: Any) -> Any:
    return lambda x: where(value_of(x) < 0.0, -x, x)


def _sqrt_in_python(x: Any) -> Any:
    if isinstance(x, np.ndarray):
        return np.sqrt(x)
    return cmath.sqrt(x) if isinstance(x, complex) else math.sqrt(x)


def _absolute_in_python(x: Any) -> Any:
    if isinstance(x, complex):
        return x if x.real >= 0 else -x
    return abs(x)


sqrt = _elementwise("sqrt", _sqrt_in_python, _sqrt_of_dual)
nearest = _elementwise("rint", lambda x: float(round(x.real)), _nearest_of_dual)
absolute = _elementwise("fabs", _absolute_in_python, _absolute_of_dual)


def where(mask: Any, a: Any, b: Any) -> Any:
    """``a`` in the lanes where ``mask`` is true, ``b`` elsewhere."""
    if isinstance(mask, np.ndarray):
        return np.where(mask, a, b)
    return a if mask else b


@intrinsic
def _select(typingctx: Any, mask: Any, a: Any, b: Any) -> Any:
    lane = LaneType(mask.width)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        x = context.cast(builder, args[1], sig.args[1], lane)
        y = context.cast(builder, args[2], sig.args[2], lane)
        return builder.select(args[0], x, y)

    return lane(mask, a, b), codegen


@intrinsic
def _select_duals(typingctx: Any, mask: Any, a: Any, b: Any) -> Any:
    kind = dual_type(a, b)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        x, y = (context.cast(builder, args[k], sig.args[k], kind) for k in (1, 2))
        x, y = Parts(context, builder, kind, x, kind), Parts(context, builder, kind, y, kind)
        value = builder.select(args[0], x.value, y.value)
        slopes = builder.select(repeated(builder, args[0]), x.slopes, y.slopes)
        return together(context, builder, kind, value, slopes)

    return kind(mask, a, b), codegen


@overload(where, strict=False, jit_options=INLINED)
def _where(mask: Any, a: Any, b: Any) -> Any:
    if isinstance(mask, MaskType):
        if dual_type(a, b):
            return lambda mask, a, b: _select_duals(mask, a, b)
        return (lambda mask, a, b: _select(mask, a, b)) if is_plain(a, b) else None
    return lambda mask, a, b: a if mask else b


def fma(a: Any, b: Any, c: Any) -> Any:
    """a b + c rounded once in compiled code, so that every lane width rounds alike."""
    return a * b + c


@intrinsic
def _fused(typingctx: Any, a: Any, b: Any, c: Any) -> Any:
    kind = lane_type(a, b, c) or types.float64

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        values = [context.cast(builder, v, t, kind) for v, t in zip(args, sig.args, strict=True)]
        if isinstance(kind, LaneType):
            return vector_intrinsic(builder, "fma", *values)
        return builder.fma(*values)

    return kind(a, b, c), codegen


@overload(fma, strict=False, jit_options=INLINED)
def _fma(a: Any, b: Any, c: Any) -> Any:
    if dual_type(a, b, c):
        return lambda a, b, c: _fused_duals(a, b, c)
    return (lambda a, b, c: _fused(a, b, c)) if is_plain(a, b, c) else None


@intrinsic
def _fused_duals(typingctx: Any, a: Any, b: Any, c: Any) -> Any:
    kind = dual_type(a, b, c)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        pairs = zip(sig.args, args, strict=True)
        x, y, z = (Parts(context, builder, t, v, kind) for t, v in pairs)
        rest = scaled_onto(builder, y.slopes, x.value, z.slopes)
        slopes = scaled_onto(builder, x.slopes, y.value, rest)
        values = (x.value, y.value, z.value)
        value = (
            vector_intrinsic(builder, "fma", *values) if kind.width > 1 else builder.fma(*values)
        )
        return together(context, builder, kind, value, slopes)

    return kind(a, b, c), codegen


def minimum(a: Any, b: Any) -> Any:
    """The smaller number, lane by lane; ``b`` where ``a`` is NaN."""
    return where(a < b, a, b)


def maximum(a: Any, b: Any) -> Any:
    """The larger number, lane by lane; ``b`` where ``a`` is NaN."""
    return where(a > b, a, b)


overload(minimum, strict=False, jit_options=INLINED)(lambda a, b: lambda a, b: where(a < b, a, b))
overload(maximum, strict=False, jit_options=INLINED)(lambda a, b: lambda a, b: where(a > b, a, b))


def any_true(mask: Any) -> bool:
    """Whether the mask is true in at least one lane."""
    return bool(mask.any() if isinstance(mask, np.ndarray) else mask)


def negate(mask: Any) -> Any:
    """The mask with every lane inverted."""
    return not mask


@intrinsic
def _mask_any(typingctx: Any, mask: Any) -> Any:
    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        bits = builder.bitcast(args[0], ir.IntType(mask.width))
        return builder.icmp_unsigned("!=", bits, ir.Constant(bits.type, 0))

    return types.boolean(mask), codegen


@intrinsic
def _mask_not(typingctx: Any, mask: Any) -> Any:
    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        ones = splat(builder, ir.Constant(ir.IntType(1), 1), mask.width)
        return builder.xor(args[0], ones)

    return mask(mask), codegen


@overload(any_true, strict=False, jit_options=INLINED)
def _any_true(mask: Any) -> Any:
    if isinstance(mask, MaskType):
        return lambda mask: _mask_any(mask)
    return lambda mask: bool(mask)


@overload(negate, strict=False, jit_options=INLINED)
def _negate(mask: Any) -> Any:
    if isinstance(mask, MaskType):
        return lambda mask: _mask_not(mask)
    return lambda mask: not mask
