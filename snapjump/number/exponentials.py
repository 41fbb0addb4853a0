"""Logarithm and exponential in plain arithmetic: the same bits in lanes, alone and on a card.

What a system's library returns differs in the last bit from one machine to the next, and a jump
with its hundreds of contacts makes thousandths of a length of it. Algorithms and polynomials are
those of fdlibm, good to one unit in the last place.
"""

import cmath
import math
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic, overload

from snapjump.number.dispatch import INLINED, kernel
from snapjump.number.dual import dual, slopes_of, times, value_of
from snapjump.number.dual_type import DualType
from snapjump.number.functions import fma, is_plain, maximum, minimum, nearest, where
from snapjump.number.lane import LaneType, splat

# ln 2 in two parts: small integers times the first are exact.
LN2 = 6.93147180369123816490e-01
LN2_REST = 1.90821492927058770002e-10
OVER_LN2 = 1.44269504088896338700e00
LOGARITHM = (
    6.666666666666735130e-01,
    3.999999999940941908e-01,
    2.857142874366239149e-01,
    2.222219843214978396e-01,
    1.818357216161805012e-01,
    1.531383769920937332e-01,
    1.479819860511658591e-01,
)
EXPONENTIAL = (
    1.66666666666666019037e-01,
    -2.77777777770155933842e-03,
    6.61375632143793436117e-05,
    -1.65339022054652515390e-06,
    4.13813679705723846039e-08,
)
SMALLEST_NORMAL = 2.2250738585072014e-308
ROOT_OF_TWO = 1.4142135623730951
BIAS = 1023.0  # of the exponent's bits
UNIT_BITS = 0x3FF0000000000000  # of 1.0
MANTISSA_BITS = 0x000FFFFFFFFFFFFF
# 2^52: the integers from here on stand in the lowest bits of their own.
INTEGERS_FROM = 4503599627370496.0
INTEGERS_FROM_BITS = 0x4330000000000000


def _on_bits(apply: Any) -> Any:
    """An intrinsic that applies integer instructions to the bits of a double, or of each lane."""

    @intrinsic
    def of_number(typingctx: Any, x: Any) -> Any:
        kind = x if isinstance(x, LaneType) else types.float64

        def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            integer = ir.IntType(64)

            def constant(value: int) -> Any:
                single = ir.Constant(integer, value)
                return splat(builder, single, x.width) if isinstance(x, LaneType) else single

            value = context.cast(builder, args[0], sig.args[0], kind)
            bits = builder.bitcast(value, constant(0).type)
            return builder.bitcast(apply(builder, bits, constant), value.type)

        return kind(x), codegen

    return of_number


# Of a positive normal number m 2^k, 1 <= m < 2: m itself, and 2^52 + k + BIAS.
_mantissa = _on_bits(lambda b, bits, c: b.or_(b.and_(bits, c(MANTISSA_BITS)), c(UNIT_BITS)))
_exponent_bits = _on_bits(lambda b, bits, c: b.or_(b.lshr(bits, c(52)), c(INTEGERS_FROM_BITS)))
# Of 2^52 + k + BIAS: 2^k.
_power = _on_bits(lambda b, bits, c: b.shl(bits, c(52)))


@kernel
def logarithm(x: Any) -> Any:
    """Natural logarithm: NaN below zero, -inf at zero, as ever."""
    tiny = x < SMALLEST_NORMAL
    normal = where(tiny, x * 18014398509481984.0, x)  # 2^54
    m = _mantissa(normal)
    k = _exponent_bits(normal) - INTEGERS_FROM - BIAS - where(tiny, 54.0, 0.0)
    upper = m > ROOT_OF_TWO
    m = where(upper, 0.5 * m, m)
    k = where(upper, k + 1.0, k)
    f = m - 1.0
    s = f / (2.0 + f)
    z = s * s
    p = fma(z, LOGARITHM[6], LOGARITHM[5])
    p = fma(z, p, LOGARITHM[4])
    p = fma(z, p, LOGARITHM[3])
    p = fma(z, p, LOGARITHM[2])
    p = fma(z, p, LOGARITHM[1])
    p = z * fma(z, p, LOGARITHM[0])
    half = 0.5 * f * f
    value = k * LN2 - ((half - fma(s, half + p, k * LN2_REST)) - f)
    value = where(x < math.inf, value, x)
    return where(x > 0.0, value, where(x == 0.0, -math.inf, math.nan))


@kernel
def exponential(x: Any) -> Any:
    """e to the power of x."""
    k = nearest(minimum(maximum(x * OVER_LN2, -1100.0), 1100.0))
    high = fma(-k, LN2, x)
    low = k * LN2_REST
    r = high - low
    z = r * r
    p = fma(z, EXPONENTIAL[4], EXPONENTIAL[3])
    p = fma(z, p, EXPONENTIAL[2])
    p = fma(z, p, EXPONENTIAL[1])
    p = fma(z, p, EXPONENTIAL[0])
    c = fma(-z, p, r)
    value = 1.0 - ((low - r * c / (2.0 - c)) - high)
    # In two factors, neither of which leaves the normal numbers.
    first = nearest(0.5 * k)
    value = value * _power(first + (INTEGERS_FROM + BIAS))
    value = value * _power((k - first) + (INTEGERS_FROM + BIAS))
    value = where(x > 710.0, math.inf, value)
    return where(x < -746.0, 0.0, value)


def log(x: Any) -> Any:
    """Natural logarithm; in plain Python the library's, of complex numbers too."""
    return cmath.log(x) if isinstance(x, complex) else math.log(x)


def exp(x: Any) -> Any:
    """e to the power of x; in plain Python the library's, of complex numbers too."""
    return cmath.exp(x) if isinstance(x, complex) else math.exp(x)


@overload(log, strict=False, jit_options=INLINED)
def _log(x: Any) -> Any:
    if isinstance(x, DualType):
        return lambda x: dual(logarithm(value_of(x)), times(slopes_of(x), 1.0 / value_of(x)))
    return (lambda x: logarithm(x)) if is_plain(x) else None


@overload(exp, strict=False, jit_options=INLINED)
def _exp(x: Any) -> Any:
    if isinstance(x, DualType):

        def differentiated(x: Any) -> Any:
            value = exponential(value_of(x))
            return dual(value, times(slopes_of(x), value))

        return differentiated
    return (lambda x: exponential(x)) if is_plain(x) else None
