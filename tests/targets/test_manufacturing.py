"""What one percent costs, against the closed form of a map."""

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpSimulator, problem

from snapjump.inverse.base import Solution
from snapjump.targets.designed import one_percent_costs_bar

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
