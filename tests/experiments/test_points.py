"""Errors with failures, orders and limits of known sequences, the Pareto front, recommendations."""

import math
from typing import Any

import numpy as np
import pytest
from cells import done

from experiments.designs import baseline_sweep
from experiments.errors import percentile, relative_errors, roughness
from experiments.order import fitted_order, observed_order, richardson
from experiments.tradeoff.points import Point, cheapest, make_point, pareto

LIMIT_ROWS = [
    {"kind": "design", "status": "ok", "x_bar": 2.0, "y_bar": 10.0},
    {"kind": "design", "status": "ok", "x_bar": 0.0, "y_bar": 5.0},
    *[{"kind": "sweep", "status": "ok", "x_bar": 1.0 * k, "y_bar": 1.0} for k in range(5)],
]


def point_of(rows: list[dict[str, Any]], status: str = "ok") -> Point:
    """A point, of cells that are finished, against the limit."""
    found, limit = (
        done("a", [{"ms": 2.0, "newton_iterations": 10.0, **row} for row in some], ended, "why")
        for some, ended in ((rows, status), (LIMIT_ROWS, "ok"))
    )
    return make_point("a", "b", found, limit)


def test_the_front_is_what_nothing_beats():
    costs = [1.0, 2.0, 3.0, 4.0, 5.0, math.nan]
    errors = [9.0, 10.0, 4.0, 4.0, 1.0, 0.0]
    assert pareto(costs, errors) == [0, 2, 4]
    assert pareto([1.0, 1.0], [2.0, 1.0]) == [1]
    assert pareto([1.0], [math.inf]) == []


def test_failures_are_infinite_errors():
    errors = np.array([1.0, 2.0, 3.0, np.nan])
    assert percentile(errors, 50.0) == pytest.approx(2.5)
    assert percentile(errors, 95.0) == math.inf
    assert percentile(errors[:3], 50.0) == pytest.approx(np.percentile(errors[:3], 50.0))


def test_errors_of_x_are_bounded_where_x_goes_through_zero():
    x, y = relative_errors(
        np.array([2.1, 0.1]), np.array([10.0, 5.05]), np.array([2.0, 0.0]), np.array([10.0, 5.0])
    )
    np.testing.assert_allclose(x, [5.0, 20.0])
    np.testing.assert_allclose(y, [0.0, 1.0])


def test_roughness_is_what_a_line_leaves():
    assert roughness(np.array([1.0, 2.0, 3.0, 4.0])) == pytest.approx(0.0, abs=1e-12)
    assert roughness(np.array([0.0, 1.0, 0.0, 1.0])) == pytest.approx(np.sqrt(0.2))
    assert math.isnan(roughness(np.array([0.0, np.nan, 0.0, 1.0])))
    lags = [design[0] for design in baseline_sweep(5)]
    np.testing.assert_allclose(lags, [0.098, 0.099, 0.1, 0.101, 0.102])


def test_a_point_compares_with_the_limit():
    off = [{**row, "x_bar": row["x_bar"] + 0.05} for row in LIMIT_ROWS]
    point = point_of(off)
    assert point.x_median_percent == pytest.approx(0.5 * (2.5 + 10.0))
    assert point.y_p95_percent == 0.0 and point.x_roughness_bar == pytest.approx(0.0, abs=1e-12)
    assert (point.ms, point.newton_iterations, point.failed, point.jumps) == (2.0, 10.0, 0, 7)


def test_an_absurd_result_is_a_failure_whatever_its_status():
    absurd = [{**LIMIT_ROWS[0], "y_bar": 1e6}, *LIMIT_ROWS[1:-1], {**LIMIT_ROWS[-1], "y_bar": 3.0}]
    point = point_of(absurd)
    assert point.failed == 2 and point.remark == "2 silently wrong"
    assert cheapest([point], 1e9) is None


def test_a_failed_jump_and_a_refused_cell():
    lost = [{**LIMIT_ROWS[0], "status": "step_underflow", "x_bar": None}, *LIMIT_ROWS[1:]]
    point = point_of(lost)
    assert point.failed == 1 and point.remark == "1 step_underflow"
    assert point.row()["x_p95_percent"] is None
    refused, good = point_of([], "refused"), point_of(LIMIT_ROWS)
    assert refused.jumps == 0 and refused.remark == "refused: why"
    assert cheapest([point, refused, good], 1.0) is good
    assert cheapest([point, refused], 1.0) is None


SIZES = [0.4, 0.2, 0.13, 0.06, 0.05]


@pytest.mark.parametrize("order", [0.5, 1.0, 2.0, 4.3])
def test_an_exact_power_on_uneven_sizes(order):
    values = [7.0 - 3.0 * h**order for h in SIZES]
    assert observed_order(SIZES[-3:], values[-3:]) == pytest.approx(order, rel=1e-6)
    limit = richardson(SIZES, values)
    assert limit.asymptotic and limit.uncertainty < 1e-9
    assert limit.value == pytest.approx(7.0, abs=1e-9)
    assert fitted_order(SIZES, [3.0 * h**order for h in SIZES]) == pytest.approx(order)


def test_the_uncertainty_bounds_the_error_of_a_second_term():
    sizes = [2.0**-k for k in range(4, 10)]
    limit = richardson(sizes, [1.0 + h**2 + 5.0 * h**3 for h in sizes])
    assert limit.asymptotic
    assert abs(limit.value - 1.0) < limit.uncertainty < 1e-4


def test_irregular_and_too_few_values_are_told_and_not_extrapolated():
    limit = richardson([0.4, 0.2, 0.1, 0.05], [1.0, 1.4, 1.1, 1.3])
    assert not limit.asymptotic and math.isnan(limit.order)
    assert limit.value == 1.3 and limit.uncertainty == pytest.approx(0.3)
    # Orders that differ are no range of convergence.
    assert not richardson([0.8, 0.4, 0.2, 0.1], [0.0, 1.0, 1.9, 1.95]).asymptotic
    assert not richardson([0.2, 0.1], [1.0, 2.0]).asymptotic
    assert math.isnan(fitted_order([0.1], [0.2]))
    assert math.isnan(fitted_order([0.2, 0.1], [0.0, np.nan]))
    # Sizes that do not fall have no order.
    assert math.isnan(observed_order([0.2, 0.1, 0.1], [1.0, 1.5, 1.7]))
