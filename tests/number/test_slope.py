"""Values with their slopes, against complex steps, over doubles, lanes and duals."""

import numpy as np
import pytest
from duals import view_duals
from numba import njit

from snapjump.number.dispatch import PROGRAM
from snapjump.number.exponentials import exp, log
from snapjump.number.functions import absolute, fma, maximum, minimum, sqrt, where
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
from snapjump.number.slope import slope_in, sloped, value_in
from snapjump.number.trigonometry import arctan, cos, sin

program = njit(**{**PROGRAM, "cache": False})
STEP = 1e-30

FUNCTIONS = {
    "polynomial": lambda x: 2.0 * x * x * x - x / 3 + 1,
    "quotient": lambda x: (1.0 - x) / (x * x + 2.0),
    "root and logarithm": lambda x: sqrt(x) * log(x / 0.3) - exp(-x),
    "angles": lambda x: sin(2.0 * x) * cos(x) + arctan(3.0 * x),
    "choices": lambda x: where(x > 0.7, x * x, 0.0) + maximum(x, 0.5) - minimum(2.0 * x, 1.0),
    "fused": lambda x: fma(x, -x, 2.0 * absolute(-x)),
    "in place": lambda x: x - 2.0,
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_slopes_are_those_of_complex_steps(name):
    function = FUNCTIONS[name]
    compiled = njit(function)

    @program
    def both(x, rate):
        found = compiled(sloped(x, rate))
        return value_in(found), slope_in(found)

    @program
    def in_lanes(points, values, slopes, lanes):
        x = view_numbers(points, lanes)[0]
        found = compiled(sloped(x, 3.0))
        view_numbers(values, lanes)[0] = value_in(found)
        view_numbers(slopes, lanes)[0] = slope_in(found)

    points, values, slopes = (aligned_zeros((1, 8)) for _ in range(3))
    points[0] = np.linspace(0.2, 1.6, 8)
    in_lanes(points, values, slopes, (0,) * 8)
    for k, x in enumerate(points[0]):
        moved = np.complex128(complex(x, STEP))
        expected = 3.0 * np.imag(function(moved)) / STEP
        value, slope = both(x, 3.0)
        assert value == pytest.approx(np.real(function(moved)), rel=1e-14)
        assert slope == pytest.approx(expected, rel=1e-12, abs=1e-14)
        assert (values[0, k], slopes[0, k]) == (value, slope)


def test_slopes_of_duals_are_second_derivatives():
    @njit
    def cube(x):
        return x * x * x

    @program
    def second(memory):
        x = view_duals(memory)
        x[1] = slope_in(cube(sloped(x[0], 1.0)))

    memory = aligned_zeros((2, 8))
    memory[0, 0], memory[0, 4] = 0.7, 1.0
    second(memory)
    assert memory[1, 0] == pytest.approx(3.0 * 0.49)
    assert memory[1, 4] == pytest.approx(6.0 * 0.7)
