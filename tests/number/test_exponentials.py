"""Logarithm and exponential in plain arithmetic, functions for Python code, against libraries'."""

import math

import numpy as np
import pytest
from numba import njit

from snapjump.number.exponentials import exp, log
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
from snapjump.number.portable import log1p, power


@njit
def evaluate(given, found, lanes):
    x, y = view_numbers(given, lanes), view_numbers(found, lanes)
    for i in range(x.shape[0]):
        y[0, i] = log(x[i])
        y[1, i] = exp(x[i])


def evaluated(values, lanes):
    given = aligned_zeros((len(values) // lanes, lanes))
    given[...] = values.reshape(given.shape)
    found = aligned_zeros((2, *given.shape))
    evaluate(given, found, (0,) * lanes)
    return found.reshape(2, -1)


def units_apart(found, exact):
    """Difference in units of the last place."""
    return np.abs(found - exact) / np.spacing(np.abs(exact.astype(float)))


POSITIVE = {
    "near one": 1.0 + np.random.default_rng(1).normal(size=40_000) * 1e-3,
    "of all sizes": 2.0 ** np.random.default_rng(0).uniform(-1070.0, 1023.0, 40_000),
}
positive = pytest.mark.parametrize("values", POSITIVE.values(), ids=POSITIVE)


@positive
def test_logarithms_are_good_to_one_unit(values):
    exact = np.log(values.astype(np.longdouble))
    assert units_apart(evaluated(values, 1)[0], exact).max() < 1.0


def test_exponentials_are_good_to_one_unit():
    values = np.random.default_rng(2).uniform(-745.0, 709.5, 40_000)
    exact = np.exp(values.astype(np.longdouble))
    assert units_apart(evaluated(values, 1)[1], exact).max() < 1.0


@positive
def test_lanes_have_the_same_bits(values):
    assert np.array_equal(evaluated(values, 8), evaluated(values, 1), equal_nan=True)


@pytest.mark.parametrize("base", [1e-3, 0.3, 1.0, 1.857, 40.0])
@pytest.mark.parametrize("exponent", [-2.0, 0.5, 1.0, 2.8])
def test_power(base, exponent):
    assert power(base, exponent) == pytest.approx(base**exponent, rel=1e-14)


@pytest.mark.parametrize("x", [-0.9, -1e-3, -1e-17, 0.0, 1e-17, 1e-9, 0.3, 5.0])
def test_logarithm_of_one_plus(x):
    assert log1p(x) == pytest.approx(math.log1p(x), rel=1e-15)
