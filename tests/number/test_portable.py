"""Functions for Python code, against those of the system's library."""

import math

import pytest

from snapjump.number.portable import log1p, power


@pytest.mark.parametrize("base", [1e-3, 0.3, 1.0, 1.857, 40.0])
@pytest.mark.parametrize("exponent", [-2.0, 0.5, 1.0, 2.8])
def test_power(base, exponent):
    assert power(base, exponent) == pytest.approx(base**exponent, rel=1e-14)


@pytest.mark.parametrize("x", [-0.9, -1e-3, -1e-17, 0.0, 1e-17, 1e-9, 0.3, 5.0])
def test_logarithm_of_one_plus(x):
    assert log1p(x) == pytest.approx(math.log1p(x), rel=1e-15)
