"""Orders and limits of sequences that are known."""

import math

import numpy as np
import pytest

from experiments.order import fitted_order, observed_order, richardson

SIZES = [0.4, 0.2, 0.13, 0.06, 0.05]


@pytest.mark.parametrize("order", [0.5, 1.0, 2.0, 4.3])
def test_an_exact_power_on_uneven_sizes(order):
    values = [7.0 - 3.0 * h**order for h in SIZES]
    assert observed_order(SIZES[-3:], values[-3:]) == pytest.approx(order, rel=1e-6)
    limit = richardson(SIZES, values)
    assert limit.asymptotic
    assert limit.value == pytest.approx(7.0, abs=1e-9)
    assert limit.uncertainty < 1e-9
    errors = [3.0 * h**order for h in SIZES]
    assert fitted_order(SIZES, errors) == pytest.approx(order)


def test_the_uncertainty_bounds_the_error_of_a_second_term():
    sizes = [2.0**-k for k in range(4, 10)]
    limit = richardson(sizes, [1.0 + h**2 + 5.0 * h**3 for h in sizes])
    assert limit.asymptotic
    assert abs(limit.value - 1.0) < limit.uncertainty < 1e-4


def test_irregular_values_are_told_and_not_extrapolated():
    limit = richardson([0.4, 0.2, 0.1, 0.05], [1.0, 1.4, 1.1, 1.3])
    assert not limit.asymptotic and math.isnan(limit.order)
    assert limit.value == 1.3 and limit.uncertainty == pytest.approx(0.3)


def test_orders_that_differ_are_no_range_of_convergence():
    sizes = [0.8, 0.4, 0.2, 0.1]
    values = [0.0, 1.0, 1.9, 1.95]
    assert not richardson(sizes, values).asymptotic


def test_sizes_that_do_not_fall_have_no_order():
    assert math.isnan(observed_order([0.2, 0.1, 0.1], [1.0, 1.5, 1.7]))


def test_too_few_values_have_no_limit():
    assert not richardson([0.2, 0.1], [1.0, 2.0]).asymptotic
    assert math.isnan(fitted_order([0.1], [0.2]))
    assert math.isnan(fitted_order([0.2, 0.1], [0.0, np.nan]))
