"""What errors cost, against the closed form of maps."""

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpSimulator, problem

from snapjump.inverse.base import Solution
from snapjump.targets.manufacturing import ErrorCurves, alone_off, one_percent_costs_bar

CONTROLS = np.array([0.1, 0.2])
Y = HEIGHT * 0.2
X = SLOPE * 0.1 * Y
# x is in proportion to delta_alpha, both to epsilon and to 1 / mass_bar; tanh(3 mu) at 0.3.
MU = 0.01 * X * 0.9 * (1.0 / np.tanh(0.9) - np.tanh(0.9))
EXPECTED = [0.01 * X, 0.01 * np.hypot(X, Y), 0.01 * np.hypot(X, Y), MU]
SOLUTION = Solution(CONTROLS, np.array([X, Y]), False)


def test_against_the_closed_form():
    given = problem([X, Y])
    # Differences over two percent are off by the square of one.
    assert one_percent_costs_bar(given, SOLUTION) == pytest.approx(EXPECTED, rel=2e-4)
    assert given.simulator.simulations == 8


def test_what_does_not_jump_has_no_cost():
    given = problem([X, Y], simulator=MadeUpSimulator(shift=(np.nan, 0.0)))
    assert np.isnan(one_percent_costs_bar(given, SOLUTION)).all()


def test_each_number_alone_is_off():
    design = np.array([0.1, 0.2, 0.768, 0.3])
    made = alone_off(design, (0.8, 1.2)).reshape(4, 2, 4)
    expected = np.stack([np.ones((4, 4)) + share * np.eye(4) for share in (-0.2, 0.2)], axis=1)
    assert made / design == pytest.approx(expected)


def test_curves_of_an_apex_that_goes_as_a_square():
    factors = np.linspace(0.8, 1.2, 41)
    apexes = np.array([5.0, 14.0]) * np.broadcast_to(factors[None, :, None] ** 2, (4, 41, 2))
    square = ErrorCurves.of(apexes, factors)
    twos = np.full((4, 2), 2.0)
    assert square.secants(0.02) == pytest.approx(twos)
    assert square.trends == pytest.approx(twos)
    # (1 + e)^2 is off its tangent by e^2.
    for error in (0.01, 0.05, 0.2):
        assert square.deviations(twos, error) == pytest.approx(error**2)
    assert square.largest.max() == pytest.approx(0.44)
    assert square.roughness == pytest.approx(2e-4)
