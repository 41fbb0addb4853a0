"""A number type for numba: a value and its derivative, both of any number type.

Laws are differentiated with it where they do not give a derivative themselves: a function written
in plain arithmetic compiles, unchanged, for a :class:`SlopeType` over doubles, lanes or duals, and
carries the derivative by one variable along. Comparisons look at values alone.
"""

import operator
from collections.abc import Callable
from typing import Any

import numpy as np
from numba.core import cgutils, types
from numba.extending import intrinsic, models, overload, register_model

from snapjump.number.dispatch import INLINED
from snapjump.number.exponentials import exp, log
from snapjump.number.functions import absolute, fma, nearest, sqrt, where

STEP = 2.0**-100


class SlopeType(types.Type):
    """The type of a value with its slope; plain numbers mixed with it have none."""

    def __init__(self, base: types.Type):
        self.base = base
        super().__init__(name=f"Slope({base})")


@register_model(SlopeType)
class SlopeModel(models.StructModel):
    """A value and a slope of the same type."""

    def __init__(self, dmm: Any, fe_type: SlopeType):
        super().__init__(dmm, fe_type, [("value", fe_type.base), ("slope", fe_type.base)])


@intrinsic
def sloped(typingctx: Any, value: Any, slope: Any) -> Any:
    """A value with its slope, of one type."""
    base = typingctx.unify_types(value, slope)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        pair = cgutils.create_struct_proxy(sig.return_type)(context, builder)
        pair.value = context.cast(builder, args[0], sig.args[0], base)
        pair.slope = context.cast(builder, args[1], sig.args[1], base)
        return pair._getvalue()

    return SlopeType(base)(value, slope), codegen


def _reader(name: str) -> Any:
    """An intrinsic that reads one half of a sloped number."""

    @intrinsic
    def read(typingctx: Any, number: Any) -> Any:
        def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            pair = cgutils.create_struct_proxy(sig.args[0])(context, builder, value=args[0])
            return getattr(pair, name)

        return number.base(number), codegen

    return read


_read_value, _read_slope = _reader("value"), _reader("slope")


def value_in(number: Any) -> Any:
    """The value of a number, sloped or plain; plain Python has plain numbers only."""
    return number


def slope_in(number: Any) -> Any:
    """The slope of a number; of a plain one 0."""
    return 0.0


def derivative(function: Any, number: Any) -> Any:
    """Derivative of a function of one number in plain Python, by a complex step: exact to rounding
    (a power of two, so that what is linear stays exact)."""
    return np.imag(function(np.complex128(complex(number, STEP)))) / STEP


@overload(value_in, strict=False, jit_options=INLINED)
def _value_in(number: Any) -> Any:
    if isinstance(number, SlopeType):
        return lambda number: _read_value(number)
    return lambda number: number


@overload(slope_in, strict=False, jit_options=INLINED)
def _slope_in(number: Any) -> Any:
    if isinstance(number, SlopeType):
        return lambda number: _read_slope(number)
    return lambda number: 0.0


def has_slope(*kinds: types.Type) -> bool:
    """Whether one of the types is sloped."""
    return any(isinstance(kind, SlopeType) for kind in kinds)


def _of_one(function: Callable[..., Any], impl: Callable[..., Any]) -> None:
    """Teach numba a function of a sloped number."""
    overload(function, strict=False, jit_options=INLINED)(lambda x: impl if has_slope(x) else None)


def _of_two(function: Callable[..., Any], impl: Callable[..., Any]) -> None:
    """Teach numba a function of two numbers, one of which is sloped or both."""
    overload(function, strict=False, jit_options=INLINED)(
        lambda x, y: impl if has_slope(x, y) else None
    )


def _sum(x: Any, y: Any) -> Any:
    return sloped(value_in(x) + value_in(y), slope_in(x) + slope_in(y))


def _difference(x: Any, y: Any) -> Any:
    return sloped(value_in(x) - value_in(y), slope_in(x) - slope_in(y))


def _product(x: Any, y: Any) -> Any:
    slope = slope_in(x) * value_in(y) + value_in(x) * slope_in(y)
    return sloped(value_in(x) * value_in(y), slope)


def _quotient(x: Any, y: Any) -> Any:
    quotient = value_in(x) / value_in(y)
    return sloped(quotient, (slope_in(x) - quotient * slope_in(y)) / value_in(y))


for _function, _impl in {
    operator.add: _sum,
    operator.sub: _difference,
    operator.mul: _product,
    operator.truediv: _quotient,
    operator.iadd: _sum,
    operator.isub: _difference,
    operator.imul: _product,
    operator.itruediv: _quotient,
    operator.lt: lambda x, y: value_in(x) < value_in(y),
    operator.le: lambda x, y: value_in(x) <= value_in(y),
    operator.gt: lambda x, y: value_in(x) > value_in(y),
    operator.ge: lambda x, y: value_in(x) >= value_in(y),
    operator.eq: lambda x, y: value_in(x) == value_in(y),
}.items():
    _of_two(_function, _impl)


def _root(x: Any) -> Any:
    root = sqrt(value_in(x))
    return sloped(root, slope_in(x) * (0.5 / root))


def _power_of_e(x: Any) -> Any:
    power = exp(value_in(x))
    return sloped(power, slope_in(x) * power)


_of_one(operator.neg, lambda x: sloped(-value_in(x), -slope_in(x)))
_of_one(sqrt, _root)
_of_one(exp, _power_of_e)
_of_one(log, lambda x: sloped(log(value_in(x)), slope_in(x) / value_in(x)))
_of_one(nearest, lambda x: nearest(value_in(x)))
_of_one(absolute, lambda x: where(value_in(x) < 0.0, -x, x))


@overload(where, strict=False, jit_options=INLINED)
def _where(mask: Any, a: Any, b: Any) -> Any:
    if not has_slope(a, b):
        return None
    return lambda mask, a, b: sloped(
        where(mask, value_in(a), value_in(b)), where(mask, slope_in(a), slope_in(b))
    )


@overload(fma, strict=False, jit_options=INLINED)
def _fma(a: Any, b: Any, c: Any) -> Any:
    if not has_slope(a, b, c):
        return None
    return lambda a, b, c: sloped(
        fma(value_in(a), value_in(b), value_in(c)),
        slope_in(a) * value_in(b) + value_in(a) * slope_in(b) + slope_in(c),
    )
