"""A number type for numba: W doubles that one SIMD instruction handles together.

A function written for one robot with plain arithmetic compiles, unchanged, for a ``float64`` or
for a :class:`LaneType`, which LLVM stores as ``<W x double>``. Comparisons of lanes give a
:class:`MaskType` (``<W x i1>``). Every lane operation is the IEEE operation of its scalar twin,
without reassociation, so that lanes and scalars agree to the last bit.
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

from snapjump.number.array import FirstTemplate, NumberArray, seen_as

DOUBLE = ir.DoubleType()


class MaskType(types.Type):
    """The type of W booleans, one a lane."""

    def __init__(self, width: int):
        self.width = width
        super().__init__(name=f"Mask{width}")


class LaneType(types.Type):
    """The type of W doubles, one a lane; scalars are broadcast when mixed with it."""

    def __init__(self, width: int):
        self.width = width
        super().__init__(name=f"Lane{width}")

    def can_convert_from(self, typingctx: Any, other: types.Type) -> Any:
        return Conversion.safe if isinstance(other, (types.Float, types.Integer)) else None

    def unify(self, typingctx: Any, other: types.Type) -> Any:
        return self if isinstance(other, (types.Float, types.Integer)) else None


@register_model(MaskType)
class MaskModel(models.PrimitiveModel):
    """A mask as an LLVM vector of bits."""

    def __init__(self, dmm: Any, fe_type: MaskType):
        super().__init__(dmm, fe_type, ir.VectorType(ir.IntType(1), fe_type.width))


@register_model(LaneType)
class LaneModel(models.PrimitiveModel):
    """A lane as an LLVM vector of doubles."""

    def __init__(self, dmm: Any, fe_type: LaneType):
        super().__init__(dmm, fe_type, ir.VectorType(DOUBLE, fe_type.width))


def splat(builder: ir.IRBuilder, value: ir.Value, width: int) -> ir.Value:
    """Broadcast one LLVM value to all lanes."""
    vector = ir.Constant(ir.VectorType(value.type, width), ir.Undefined)
    single = builder.insert_element(vector, value, ir.Constant(ir.IntType(32), 0))
    zeros = ir.Constant(ir.VectorType(ir.IntType(32), width), None)
    return builder.shuffle_vector(single, vector, zeros)


@lower_cast(types.Float, LaneType)
@lower_cast(types.Integer, LaneType)
def _broadcast(context: Any, builder: Any, fromty: Any, toty: Any, value: Any) -> Any:
    return splat(builder, context.cast(builder, value, fromty, types.float64), toty.width)


def lane_type(*args: types.Type) -> LaneType | None:
    """The lane type among the arguments when the others are numbers, else None."""
    lanes = [a for a in args if isinstance(a, LaneType)]
    rest = [a for a in args if not isinstance(a, (LaneType, types.Float, types.Integer))]
    return lanes[0] if lanes and not rest else None


def _compare(builder: ir.IRBuilder, name: str, x: ir.Value, y: ir.Value) -> ir.Value:
    """IEEE comparison: false with a NaN, but for ``!=``, which is then true."""
    compare = builder.fcmp_unordered if name == "!=" else builder.fcmp_ordered
    return compare(name, x, y)


def _define(function: Callable[..., Any], arity: int, build: Any, returns_mask: bool) -> None:
    """Teach numba ``function`` of ``arity`` lanes (numbers are broadcast)."""

    @infer_global(function)
    class _Typing(FirstTemplate):
        def generic(self, args: Any, kws: Any) -> Any:
            lane = lane_type(*args) if len(args) == arity else None
            if lane is not None:
                returned = MaskType(lane.width) if returns_mask else lane
                return signature(returned, *[lane] * arity)
            return None

    @lower_builtin(function, *[LaneType] * arity)
    def _lowering(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return build(builder, *args)


for _function, _name in {
    operator.add: "fadd",
    operator.sub: "fsub",
    operator.mul: "fmul",
    operator.truediv: "fdiv",
    operator.iadd: "fadd",
    operator.isub: "fsub",
    operator.imul: "fmul",
    operator.itruediv: "fdiv",
}.items():
    _define(_function, 2, lambda b, x, y, n=_name: getattr(b, n)(x, y), False)

_define(operator.neg, 1, lambda b, x: b.fneg(x), False)

for _function, _name in {
    operator.lt: "<",
    operator.le: "<=",
    operator.gt: ">",
    operator.ge: ">=",
    operator.eq: "==",
    operator.ne: "!=",
}.items():
    _define(_function, 2, lambda b, x, y, n=_name: _compare(b, n, x, y), True)


def _define_mask(function: Callable[..., Any], arity: int, build: Any) -> None:
    @infer_global(function)
    class _Typing(FirstTemplate):
        def generic(self, args: Any, kws: Any) -> Any:
            if len(args) == arity and all(isinstance(a, MaskType) for a in args):
                return signature(args[0], *args)
            return None

    @lower_builtin(function, *[MaskType] * arity)
    def _lowering(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return build(builder, *args)


_define_mask(operator.and_, 2, lambda b, x, y: b.and_(x, y))
_define_mask(operator.or_, 2, lambda b, x, y: b.or_(x, y))
_define_mask(operator.iand, 2, lambda b, x, y: b.and_(x, y))
_define_mask(operator.ior, 2, lambda b, x, y: b.or_(x, y))


def vector_intrinsic(builder: ir.IRBuilder, name: str, *args: ir.Value) -> ir.Value:
    """Call ``llvm.<name>`` on vectors of doubles."""
    kind = args[0].type
    full = f"llvm.{name}.v{kind.count}f64"
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(kind, [kind] * len(args)), full
    )
    return builder.call(function, args)


@intrinsic
def view_numbers(typingctx: Any, array: Any, lanes: Any) -> Any:
    """View a float64 array of shape (..., W) as an array of numbers of shape (...).

    ``lanes`` is a tuple of W integers, of which only the length counts: one gives plain doubles,
    more give lanes, whose array must be C-contiguous. The data must be aligned to 8 W bytes
    (:mod:`snapjump.number.memory`), and the caller keeps the array alive.
    """
    width = lanes.count
    if (array.layout != "C" and width > 1) or array.dtype != types.float64:
        raise TypeError(f"view_numbers needs C-contiguous doubles, not {array}")
    number = types.float64 if width == 1 else LaneType(width)
    viewed = NumberArray(number, array.ndim - 1, "C" if array.layout == "C" else "A")

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return seen_as(context, builder, viewed, array, args[0])

    return viewed(array, lanes), codegen
