"""A number type for numba: a value and its derivatives by four parameters.

Kernels written in plain arithmetic compile, unchanged, for a :class:`DualType`, and then
differentiate themselves (forward mode): every operation carries the derivatives along, four in
one SIMD register, or those of every lane in four. Comparisons look at values alone. Values are
computed by the very operations of a ``float64`` or of lanes, and so are slopes: those of lanes
agree with those of doubles to the last bit.
"""

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.core.imputils import lower_builtin, lower_cast
from numba.core.typing.templates import infer_global, signature
from numba.extending import intrinsic

from snapjump.number.array import FirstTemplate
from snapjump.number.dual_type import (
    PARAMETERS,
    DualType,
    Parts,
    added,
    by_parameter,
    compared,
    dual_over,
    dual_type,
    plain,
    repeated,
    scaled,
    scaled_onto,
    together,
)
from snapjump.number.lane import LaneType, splat, vector_intrinsic


def _sum(builder: Any, x: Parts, y: Parts) -> Any:
    return builder.fadd(x.value, y.value), added(builder, x.slopes, y.slopes)


def _difference(builder: Any, x: Parts, y: Parts) -> Any:
    minus = None if y.slopes is None else builder.fneg(y.slopes)
    return builder.fsub(x.value, y.value), added(builder, x.slopes, minus)


def _product(builder: Any, x: Parts, y: Parts) -> Any:
    slopes = scaled_onto(builder, x.slopes, y.value, scaled(builder, y.slopes, x.value))
    return builder.fmul(x.value, y.value), slopes


def _quotient(builder: Any, x: Parts, y: Parts) -> Any:
    quotient = builder.fdiv(x.value, y.value)
    one = ir.Constant(ir.DoubleType(), 1.0)
    if isinstance(y.value.type, ir.VectorType):
        one = splat(builder, one, y.value.type.count)
    over = builder.fdiv(one, y.value)
    change = scaled_onto(builder, y.slopes, builder.fneg(quotient), x.slopes)
    return quotient, scaled(builder, change, over)


PAIRS = (
    (DualType, DualType),
    (DualType, types.Float),
    (types.Float, DualType),
    (DualType, LaneType),
    (LaneType, DualType),
)


def _define(function: Callable[..., Any], build: Any, compares: bool) -> None:
    """Teach numba a function of two numbers of which one or both are duals."""

    @infer_global(function)
    class _Typing(FirstTemplate):
        def generic(self, args: Any, kws: Any) -> Any:
            kind = dual_type(*args) if len(args) == 2 else None
            if kind is None:
                return None
            return signature(compared(kind) if compares else kind, *[plain(a) for a in args])

    def lowering(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        kind = dual_type(*sig.args)
        parts = [Parts(context, builder, t, a, kind) for t, a in zip(sig.args, args, strict=True)]
        result = build(builder, *parts)
        return result if compares else together(context, builder, kind, *result)

    for pair in PAIRS:
        lower_builtin(function, *pair)(lowering)


for _function, _build in {
    operator.add: _sum,
    operator.sub: _difference,
    operator.mul: _product,
    operator.truediv: _quotient,
    operator.iadd: _sum,
    operator.isub: _difference,
    operator.imul: _product,
    operator.itruediv: _quotient,
}.items():
    _define(_function, _build, False)

for _function, _name in {
    operator.lt: "<",
    operator.le: "<=",
    operator.gt: ">",
    operator.ge: ">=",
    operator.eq: "==",
}.items():
    _define(
        _function,
        lambda builder, x, y, name=_name: builder.fcmp_ordered(name, x.value, y.value),
        True,
    )


@infer_global(operator.neg)
class _Negation(FirstTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(args[0], *args) if isinstance(args[0], DualType) else None


@lower_builtin(operator.neg, DualType)
def _negative(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    x = Parts(context, builder, sig.args[0], args[0], sig.args[0])
    value, slopes = builder.fneg(x.value), builder.fneg(x.slopes)
    return together(context, builder, sig.args[0], value, slopes)


@lower_cast(types.Float, DualType)
@lower_cast(types.Integer, DualType)
@lower_cast(LaneType, DualType)
def _constant(context: Any, builder: Any, fromty: Any, toty: Any, value: Any) -> Any:
    return together(context, builder, toty, context.cast(builder, value, fromty, toty.base), None)


@intrinsic
def dual(typingctx: Any, value: Any, slopes: Any) -> Any:
    """The dual of a value and its slopes."""
    kind = dual_over(value)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return together(context, builder, kind, *args)

    return kind(kind.base, kind.slopes), codegen


@intrinsic
def constant(typingctx: Any, value: Any) -> Any:
    """The dual of a number that depends on no parameter."""
    kind = dual_over(value)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return together(context, builder, kind, args[0], None)

    return kind(kind.base), codegen


@intrinsic
def value_of(typingctx: Any, number: Any) -> Any:
    """The value of a dual."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return Parts(context, builder, number, args[0], number).value

    return number.base(number), codegen


@intrinsic
def slopes_of(typingctx: Any, number: Any) -> Any:
    """The slopes of a dual, lanes of one parameter after the other."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return Parts(context, builder, number, args[0], number).slopes

    return number.slopes(number), codegen


@intrinsic
def each(typingctx: Any, value: Any) -> Any:
    """A number, or lanes, once for every parameter: a factor of slopes."""
    kind = dual_over(value)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return repeated(builder, args[0])

    return kind.slopes(kind.base), codegen


@intrinsic
def times(typingctx: Any, slopes: Any, factor: Any) -> Any:
    """Slopes times a number, or times every lane's own."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return scaled(builder, *args)

    return slopes(slopes, dual_over(factor).base), codegen


@intrinsic
def plus(typingctx: Any, a: Any, b: Any) -> Any:
    """The sum of two slopes."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return added(builder, *args)

    return a(a, a), codegen


@intrinsic
def times_plus(typingctx: Any, slopes: Any, factor: Any, others: Any) -> Any:
    """Slopes times a number, rounded once with the other slopes added."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return scaled_onto(builder, *args)

    return slopes(slopes, dual_over(factor).base, slopes), codegen


@intrinsic
def steepest(typingctx: Any, number: Any) -> Any:
    """The largest absolute slope of a dual."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        slopes = Parts(context, builder, number, args[0], number).slopes
        sizes = vector_intrinsic(builder, "fabs", slopes)
        found = by_parameter(builder, sizes, 0, number)
        for k in range(1, PARAMETERS):
            one = by_parameter(builder, sizes, k, number)
            larger = builder.fcmp_ordered(">", one, found)
            found = builder.select(larger, one, found)
        return found

    return number.base(number), codegen


@intrinsic
def slope_at(typingctx: Any, slopes: Any, place: Any) -> Any:
    """One of the slopes of a dual of a double, as a number."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        index = context.cast(builder, args[1], sig.args[1], types.int32)
        return builder.extract_element(args[0], index)

    return types.float64(slopes, place), codegen
