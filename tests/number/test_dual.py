"""Numbers that carry derivatives, against differences, and against plain numbers."""

import math

import numpy as np
import pytest
from duals import view_duals
from numba import njit

from snapjump.number.dual import constant, dual, slope_at, slopes_of, value_of
from snapjump.number.dual_type import DOUBLES
from snapjump.number.exponentials import exp, log
from snapjump.number.functions import absolute, fma, maximum, minimum, nearest, sqrt, where
from snapjump.number.memory import aligned_zeros
from snapjump.number.nowhere import nowhere
from snapjump.number.trigonometry import arctan, cos, sin

FUNCTIONS = {
    "sum": lambda x, y: x + y + 2.0 + 1,
    "difference": lambda x, y: 3 - x - (y - 1.5),
    "product": lambda x, y: 2.0 * x * y * 3,
    "quotient": lambda x, y: x / y + 2.0 / x + y / 4,
    "negative": lambda x, y: -(x * y),
    "fma": lambda x, y: fma(x, y, x) + fma(2.0, y, 1.0) + fma(x, 3.0, y),
    "sqrt": lambda x, y: sqrt(x * y),
    "log": lambda x, y: log(x + y),
    "exp": lambda x, y: exp(-x * y),
    "sin": lambda x, y: sin(3.0 * x * y),
    "cos": lambda x, y: cos(7.0 * x - y),
    "arctan": lambda x, y: arctan(x / y),
    "absolute": lambda x, y: absolute(x - y) + absolute(y),
    "minimum": lambda x, y: minimum(x, y) + minimum(x, 0.1),
    "maximum": lambda x, y: maximum(x, y) + maximum(0.1, y),
    "where": lambda x, y: where(x < y, x * x, 1.0) + where(x >= y, 0.0, y),
    "nearest": lambda x, y: x * nearest(10.0 * y),
}
POINTS = ((0.7, 1.3), (1.9, 0.4))


def evaluated(function, x, y):
    """Value and slopes of a function of two duals with slopes (1, 0, 2, -1) and (0, 1, 3, 0)."""
    compiled = njit(function)

    @njit
    def run(given, result):
        duals, out = view_duals(given), view_duals(result)
        out[0] = compiled(duals[0], duals[1])

    given, result = aligned_zeros((2, DOUBLES)), aligned_zeros((1, DOUBLES))
    given[:, 0] = x, y
    given[:, 4:] = (1.0, 0.0, 2.0, -1.0), (0.0, 1.0, 3.0, 0.0)
    run(given, result)
    plain = njit(lambda x, y: 1.0 * compiled(x, y))(x, y)
    return result[0, 0], result[0, 4:], plain


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("point", POINTS)
def test_slopes_are_those_of_differences(name, point):
    function = FUNCTIONS[name]
    value, slopes, plain = evaluated(function, *point)
    assert value == plain  # to the last bit
    h = 1e-5
    for k, (dx, dy) in enumerate(((1.0, 0.0), (0.0, 1.0), (2.0, 3.0), (-1.0, 0.0))):
        x, y = point
        ahead, behind = function(x + h * dx, y + h * dy), function(x - h * dx, y - h * dy)
        assert slopes[k] == pytest.approx((ahead - behind) / (2.0 * h), rel=2e-8, abs=2e-8)


def test_comparisons_look_at_values():
    @njit
    def run(given):
        a, b = view_duals(given)[0], view_duals(given)[1]
        return a < b, a <= b, a > b, a >= 1.0, 1.0 < b, a == b, a == 1.0

    given = aligned_zeros((2, DOUBLES))
    given[:, 0] = 1.0, 2.0
    given[0, 4:] = 5.0
    assert run(given) == (True, True, False, True, True, False, True)


def test_parts_and_constants():
    @njit
    def run(given):
        duals = view_duals(given)
        d = duals[0]
        duals[1] = dual(value_of(d), slopes_of(d) * 2.0)
        duals[2] = constant(7.0)
        duals[0] = 3.0
        return slope_at(slopes_of(d), 2), duals.shape[0]

    given = aligned_zeros((3, DOUBLES))
    given[0, 0], given[0, 4:] = 1.5, (1.0, 2.0, 3.0, 4.0)
    assert run(given) == (3.0, 3)
    assert given[1].tolist() == [1.5, 0.0, 0.0, 0.0, 2.0, 4.0, 6.0, 8.0]
    assert given[2, 0] == 7.0 and not given[2, 4:].any()
    assert given[0, 0] == 3.0 and not given[0, 4:].any()


def test_memory_of_another_kind_is_refused():
    @njit
    def run(given):
        return view_duals(given)[0]

    with pytest.raises(Exception, match="view_duals needs C-contiguous doubles"):
        run(np.zeros((2, DOUBLES), dtype=np.float32))


def test_what_goes_nowhere_is_not_computed():
    """The compiled loop that writes logarithms nowhere has none."""

    @njit
    def run(values):
        lost = nowhere()
        for i in range(values.shape[0]):
            lost[i, 0] += log(values[i])
        return lost[3] + 1.0

    assert run(np.array([math.e])) == 1.0
    code = next(iter(run.inspect_asm().values()))
    assert "divsd" not in code  # as a logarithm would
