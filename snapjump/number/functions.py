"""Functions of one number that work on Python numbers, numba scalars and lanes.

In plain Python they also take complex numbers, so that tests can differentiate by a complex step.
"""

import cmath
import math
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.extending import intrinsic, overload

from snapjump.number.dispatch import INLINED, kernel
from snapjump.number.dual import (
    DUAL,
    DualType,
    Parts,
    added,
    dual,
    is_dual,
    scaled,
    slopes_of,
    together,
    value_of,
)
from snapjump.number.lane import (
    LaneType,
    MaskType,
    lane_type,
    splat,
    vector_intrinsic,
)


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
        return dual(value, slopes_of(x) * (0.5 / value))

    return differentiated


def _nearest_of_dual(rounded: Any) -> Any:
    return lambda x: rounded(value_of(x))


def _absolute_of_dual(magnitude: Any) -> Any:
    return lambda x: -x if value_of(x) < 0.0 else x


sqrt = _elementwise(
    "sqrt", lambda x: cmath.sqrt(x) if isinstance(x, complex) else math.sqrt(x), _sqrt_of_dual
)
nearest = _elementwise("rint", lambda x: float(round(x.real)), _nearest_of_dual)
absolute = _elementwise("fabs", lambda x: x if x.real >= 0 else -x, _absolute_of_dual)


def where(mask: Any, a: Any, b: Any) -> Any:
    """``a`` in the lanes where ``mask`` is true, ``b`` elsewhere."""
    return a if mask else b


@intrinsic
def _select(typingctx: Any, mask: Any, a: Any, b: Any) -> Any:
    lane = LaneType(mask.width)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        x = context.cast(builder, args[1], sig.args[1], lane)
        y = context.cast(builder, args[2], sig.args[2], lane)
        return builder.select(args[0], x, y)

    return lane(mask, a, b), codegen


@overload(where, strict=False, jit_options=INLINED)
def _where(mask: Any, a: Any, b: Any) -> Any:
    if isinstance(mask, MaskType):
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
    if is_dual(a, b, c):
        return lambda a, b, c: _fused_duals(a, b, c)
    return (lambda a, b, c: _fused(a, b, c)) if is_plain(a, b, c) else None


@intrinsic
def _fused_duals(typingctx: Any, a: Any, b: Any, c: Any) -> Any:
    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        x, y, z = (Parts(context, builder, t, v) for t, v in zip(sig.args, args, strict=True))
        product = added(
            builder, scaled(builder, x.slopes, y.value), scaled(builder, y.slopes, x.value)
        )
        value = builder.fma(x.value, y.value, z.value)
        return together(context, builder, value, added(builder, product, z.slopes))

    return DUAL(a, b, c), codegen


# pi / 2 in two parts, and the polynomials of sine and cosine on [-pi/4, pi/4] from fdlibm.
HALF_PI = 1.5707963267948966
HALF_PI_REST = 6.123233995736766e-17
SINE = (
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
)
COSINE = (
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
)


@kernel
def reduced_sine_cosine(x: Any) -> Any:
    """Sine and cosine of x less a number of quarter turns, and that number from -2 to 2.

    In plain arithmetic, which is as fast for lanes as for one number, and equal in both; good to
    about one unit in the last place for the angles of a robot (|x| < 1e5).
    """
    quarters = nearest(x * (1.0 / HALF_PI))
    r = fma(-quarters, HALF_PI_REST, fma(-quarters, HALF_PI, x))
    z = r * r
    s = fma(z, SINE[5], SINE[4])
    s = fma(z, s, SINE[3])
    s = fma(z, s, SINE[2])
    s = fma(z, s, SINE[1])
    s = fma(z, s, SINE[0])
    c = fma(z, COSINE[5], COSINE[4])
    c = fma(z, c, COSINE[3])
    c = fma(z, c, COSINE[2])
    c = fma(z, c, COSINE[1])
    c = fma(z, c, COSINE[0])
    half = 0.5 * z
    near_one = 1.0 - half
    cosine = near_one + ((1.0 - near_one - half) + z * z * c)
    return fma(z * r, s, r), cosine, quarters - 4.0 * nearest(0.25 * quarters)


@kernel
def sin(x: Any) -> Any:
    """Sine of an angle (rad)."""
    sine, cosine, quarters = reduced_sine_cosine(x)
    value = where(absolute(quarters) == 1.0, cosine, sine)
    return where((quarters == -1.0) | (absolute(quarters) == 2.0), -value, value)


@kernel
def cos(x: Any) -> Any:
    """Cosine of an angle (rad)."""
    sine, cosine, quarters = reduced_sine_cosine(x)
    value = where(absolute(quarters) == 1.0, sine, cosine)
    return where((quarters == 1.0) | (absolute(quarters) == 2.0), -value, value)


# The polynomial of the arctangent on [-7/16, 7/16] from fdlibm.
ARCTANGENT = (
    3.33333333333329318027e-01,
    -1.99999999998764832476e-01,
    1.42857142725034663711e-01,
    -1.11111104054623557880e-01,
    9.09088713343650656196e-02,
    -7.69187620504482999495e-02,
    6.66107313738753120669e-02,
    -5.83357013379057348645e-02,
    4.97687799461593236017e-02,
    -3.65315727442169155270e-02,
    1.62858201153657823623e-02,
)


@kernel
def arctan(t: Any) -> Any:
    """Angle (rad, from -pi/2 to pi/2) whose tangent is t, for |t| < 1e150.

    Beyond 7/16 the angle is halved twice, tan(a/2) = t / (1 + sqrt(1 + t^2)); that is left out
    where no lane needs it.
    """
    beyond = absolute(t) > 0.4375
    r = t
    scale = 1.0 + 0.0 * t
    if any_true(beyond):
        half = t / (1.0 + sqrt(fma(t, t, 1.0)))
        quarter = half / (1.0 + sqrt(fma(half, half, 1.0)))
        r = where(beyond, quarter, t)
        scale = where(beyond, 4.0, scale)
    z = r * r
    p = fma(z, ARCTANGENT[10], ARCTANGENT[9])
    p = fma(z, p, ARCTANGENT[8])
    p = fma(z, p, ARCTANGENT[7])
    p = fma(z, p, ARCTANGENT[6])
    p = fma(z, p, ARCTANGENT[5])
    p = fma(z, p, ARCTANGENT[4])
    p = fma(z, p, ARCTANGENT[3])
    p = fma(z, p, ARCTANGENT[2])
    p = fma(z, p, ARCTANGENT[1])
    p = fma(z, p, ARCTANGENT[0])
    return scale * fma(-(z * r), p, r)


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
    return bool(mask)


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
