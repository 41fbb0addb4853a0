"""A number type for numba: a value and its derivatives by four parameters.

Kernels written in plain arithmetic compile, unchanged, for a :class:`DualType`, and then
differentiate themselves (forward mode): every operation carries the derivatives along, four in
one SIMD register. Comparisons look at values alone. Values are computed by the very operations of
a ``float64``; derivatives may be contracted and reordered by the compiler.
"""

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.imputils import lower_builtin, lower_cast
from numba.core.typeconv import Conversion
from numba.core.typing.templates import infer_global, signature
from numba.extending import intrinsic, models, register_model

from snapjump.number.array import FirstTemplate
from snapjump.number.lane import LaneType, splat

PARAMETERS = 4
DOUBLES = 8  # of memory for one dual: the value, padding, and the slopes on a boundary of their own
FLAGS = ("nnan", "ninf", "nsz", "contract")  # for slopes: what is times nothing, is nothing
SLOPES = LaneType(PARAMETERS)


class DualType(types.Type):
    """The type of a value with its slopes; plain numbers mixed with it have none."""

    def __init__(self) -> None:
        super().__init__(name="Dual")

    def can_convert_from(self, typingctx: Any, other: types.Type) -> Any:
        return Conversion.safe if isinstance(other, (types.Float, types.Integer)) else None

    def unify(self, typingctx: Any, other: types.Type) -> Any:
        return self if isinstance(other, (types.Float, types.Integer)) else None


@register_model(DualType)
class DualModel(models.StructModel):
    """A dual as a double and a vector of four."""

    def __init__(self, dmm: Any, fe_type: DualType):
        super().__init__(dmm, fe_type, [("value", types.float64), ("slopes", SLOPES)])


DUAL = DualType()
NO_SLOPES = ir.Constant(ir.VectorType(ir.DoubleType(), PARAMETERS), None)


class Parts:
    """A dual, or a plain number, taken apart in LLVM: ``value``, and ``slopes`` or None."""

    def __init__(self, context: Any, builder: Any, kind: types.Type, number: Any):
        if isinstance(kind, DualType):
            pair = cgutils.create_struct_proxy(kind)(context, builder, value=number)
            self.value, self.slopes = pair.value, pair.slopes
        else:
            self.value, self.slopes = context.cast(builder, number, kind, types.float64), None


def together(context: Any, builder: Any, value: Any, slopes: Any) -> Any:
    """The dual of a value and its slopes (None: zero)."""
    pair = cgutils.create_struct_proxy(DUAL)(context, builder)
    pair.value = value
    pair.slopes = NO_SLOPES if slopes is None else slopes
    return pair._getvalue()


def scaled(builder: Any, slopes: Any, factor: Any) -> Any:
    """Slopes times a number."""
    if slopes is None:
        return None
    return builder.fmul(slopes, splat(builder, factor, PARAMETERS), flags=FLAGS)


def added(builder: Any, a: Any, b: Any) -> Any:
    """The sum of two slopes, either of which may be None."""
    if a is None or b is None:
        return b if a is None else a
    return builder.fadd(a, b, flags=FLAGS)


def _sum(builder: Any, x: Parts, y: Parts) -> Any:
    return builder.fadd(x.value, y.value), added(builder, x.slopes, y.slopes)


def _difference(builder: Any, x: Parts, y: Parts) -> Any:
    minus = None if y.slopes is None else builder.fneg(y.slopes)
    return builder.fsub(x.value, y.value), added(builder, x.slopes, minus)


def _product(builder: Any, x: Parts, y: Parts) -> Any:
    slopes = added(builder, scaled(builder, x.slopes, y.value), scaled(builder, y.slopes, x.value))
    return builder.fmul(x.value, y.value), slopes


def _quotient(builder: Any, x: Parts, y: Parts) -> Any:
    quotient = builder.fdiv(x.value, y.value)
    over = builder.fdiv(ir.Constant(ir.DoubleType(), 1.0), y.value)
    falling = scaled(builder, y.slopes, builder.fneg(quotient))
    return quotient, scaled(builder, added(builder, x.slopes, falling), over)


def is_dual(*kinds: types.Type) -> bool:
    """Whether there is a dual among the types and nothing but numbers beside it."""
    numbers = (DualType, types.Float, types.Integer)
    return any(isinstance(k, DualType) for k in kinds) and all(
        isinstance(k, numbers) for k in kinds
    )


def plain(kind: types.Type) -> types.Type:
    """The type as an operation takes it: a dual, or a double."""
    return kind if isinstance(kind, DualType) else types.float64


PAIRS = ((DualType, DualType), (DualType, types.Float), (types.Float, DualType))


def _define(function: Callable[..., Any], build: Any, returned: types.Type) -> None:
    """Teach numba a function of two numbers of which one or both are duals."""

    @infer_global(function)
    class _Typing(FirstTemplate):
        def generic(self, args: Any, kws: Any) -> Any:
            if len(args) == 2 and is_dual(*args):
                return signature(returned, *[plain(a) for a in args])
            return None

    def lowering(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        parts = [Parts(context, builder, t, a) for t, a in zip(sig.args, args, strict=True)]
        result = build(builder, *parts)
        return together(context, builder, *result) if returned is DUAL else result

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
    _define(_function, _build, DUAL)

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
        types.boolean,
    )


@infer_global(operator.neg)
class _Negation(FirstTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(DUAL, DUAL) if args == (DUAL,) else None


@lower_builtin(operator.neg, DualType)
def _negative(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    x = Parts(context, builder, DUAL, args[0])
    return together(context, builder, builder.fneg(x.value), builder.fneg(x.slopes))


@lower_cast(types.Float, DualType)
@lower_cast(types.Integer, DualType)
def _constant(context: Any, builder: Any, fromty: Any, toty: Any, value: Any) -> Any:
    return together(context, builder, context.cast(builder, value, fromty, types.float64), None)


@intrinsic
def dual(typingctx: Any, value: Any, slopes: Any) -> Any:
    """The dual of a value and its slopes (a lane of four)."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return together(context, builder, *args)

    return DUAL(types.float64, SLOPES), codegen


@intrinsic
def constant(typingctx: Any, value: Any) -> Any:
    """The dual of a number that depends on no parameter."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return together(context, builder, args[0], None)

    return DUAL(types.float64), codegen


@intrinsic
def value_of(typingctx: Any, number: Any) -> Any:
    """The value of a dual."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return Parts(context, builder, DUAL, args[0]).value

    return types.float64(DUAL), codegen


@intrinsic
def slopes_of(typingctx: Any, number: Any) -> Any:
    """The slopes of a dual, a lane of four."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return Parts(context, builder, DUAL, args[0]).slopes

    return SLOPES(DUAL), codegen


@intrinsic
def slope_at(typingctx: Any, slopes: Any, place: Any) -> Any:
    """One of four slopes, as a number."""

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        index = context.cast(builder, args[1], sig.args[1], types.int32)
        return builder.extract_element(args[0], index)

    return types.float64(SLOPES, place), codegen
