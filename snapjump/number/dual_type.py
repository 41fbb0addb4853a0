"""The type of duals, numbers with derivatives by four parameters, and what LLVM makes of them."""

from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typeconv import Conversion
from numba.extending import models, register_model

from snapjump.number.lane import LaneType, MaskType, splat

PARAMETERS = 4
DOUBLES = 8  # of memory for one dual of a double: the value, padding, and the slopes on a boundary
FLAGS = ("nnan", "ninf", "nsz")  # for slopes: what is times nothing, is nothing


class DualType(types.Type):
    """The type of a value (``base``: a double, or lanes) with its slopes, one parameter after the
    other; plain numbers mixed with it have none."""

    def __init__(self, base: types.Type = types.float64) -> None:
        self.base = base
        self.width = base.width if isinstance(base, LaneType) else 1
        self.slopes = LaneType(PARAMETERS * self.width)
        super().__init__(name=f"Dual({base})")

    def takes(self, other: types.Type) -> bool:
        """Whether another type is one of plain numbers that mix with this one."""
        return other == self.base or isinstance(other, (types.Float, types.Integer))

    def can_convert_from(self, typingctx: Any, other: types.Type) -> Any:
        return Conversion.safe if self.takes(other) else None

    def unify(self, typingctx: Any, other: types.Type) -> Any:
        return self if self.takes(other) else None


@register_model(DualType)
class DualModel(models.StructModel):
    """A dual as its value and one vector of all its slopes."""

    def __init__(self, dmm: Any, fe_type: DualType):
        super().__init__(dmm, fe_type, [("value", fe_type.base), ("slopes", fe_type.slopes)])


DUAL = DualType()


def no_slopes(kind: DualType) -> ir.Constant:
    """The slopes of a constant."""
    return ir.Constant(ir.VectorType(ir.DoubleType(), kind.slopes.width), None)


def repeated(builder: Any, value: Any) -> Any:
    """A double, or lanes, once for every parameter."""
    if not isinstance(value.type, ir.VectorType):
        return splat(builder, value, PARAMETERS)
    lanes = [k for _ in range(PARAMETERS) for k in range(value.type.count)]
    places = ir.Constant(ir.VectorType(ir.IntType(32), len(lanes)), lanes)
    return builder.shuffle_vector(value, ir.Constant(value.type, ir.Undefined), places)


class Parts:
    """A dual, or a plain number, taken apart in LLVM: ``value``, and ``slopes`` or None."""

    def __init__(self, context: Any, builder: Any, given: types.Type, number: Any, kind: DualType):
        if isinstance(given, DualType):
            pair = cgutils.create_struct_proxy(given)(context, builder, value=number)
            self.value, self.slopes = pair.value, pair.slopes
        else:
            self.value, self.slopes = context.cast(builder, number, given, kind.base), None


def together(context: Any, builder: Any, kind: DualType, value: Any, slopes: Any) -> Any:
    """The dual of a value and its slopes (None: zero)."""
    pair = cgutils.create_struct_proxy(kind)(context, builder)
    pair.value = value
    pair.slopes = no_slopes(kind) if slopes is None else slopes
    return pair._getvalue()


def scaled(builder: Any, slopes: Any, factor: Any) -> Any:
    """Slopes times a number."""
    if slopes is None:
        return None
    return builder.fmul(slopes, repeated(builder, factor), flags=FLAGS)


def scaled_onto(builder: Any, slopes: Any, factor: Any, others: Any) -> Any:
    """Slopes times a number, rounded once with the other slopes added."""
    if slopes is None or others is None:
        return added(builder, scaled(builder, slopes, factor), others)
    kind = slopes.type
    fma = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(kind, [kind] * 3), f"llvm.fma.v{kind.count}f64"
    )
    return builder.call(fma, [slopes, repeated(builder, factor), others], fastmath=FLAGS)


def added(builder: Any, a: Any, b: Any) -> Any:
    """The sum of two slopes, either of which may be None."""
    if a is None or b is None:
        return b if a is None else a
    return builder.fadd(a, b, flags=FLAGS)


def dual_type(*kinds: types.Type) -> Any:
    """The dual among the types where nothing but numbers that mix with it is beside it, or None."""
    duals = [kind for kind in kinds if isinstance(kind, DualType)]
    if not duals:
        return None
    known = all(kind == duals[0] or duals[0].takes(kind) for kind in kinds)
    return duals[0] if known else None


def plain(kind: types.Type) -> types.Type:
    """The type as an operation takes it: a dual, lanes, or a double."""
    return kind if isinstance(kind, (DualType, LaneType)) else types.float64


def compared(kind: DualType) -> types.Type:
    """What a comparison of duals gives."""
    return MaskType(kind.width) if kind.width > 1 else types.boolean


def by_parameter(builder: Any, slopes: Any, k: int, kind: DualType) -> Any:
    """The slopes by one parameter: a double, or lanes."""
    places = [ir.Constant(ir.IntType(32), k * kind.width + lane) for lane in range(kind.width)]
    if kind.width == 1:
        return builder.extract_element(slopes, places[0])
    chosen = ir.Constant(ir.VectorType(ir.IntType(32), kind.width), places)
    return builder.shuffle_vector(slopes, ir.Constant(slopes.type, ir.Undefined), chosen)


def dual_over(value: types.Type) -> DualType:
    """The type of duals with such values."""
    return DualType(value) if isinstance(value, LaneType) else DUAL
