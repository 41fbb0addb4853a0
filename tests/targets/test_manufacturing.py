"""What one percent costs, against the closed form of a map."""

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpModel, MadeUpSimulator, problem

from snapjump.checks import ParameterError
from snapjump.inverse.base import Solution
from snapjump.targets.manufacturing import one_percent_costs_bar

CONTROLS = np.array([0.1, 0.2])
Y = HEIGHT * 0.2
X = SLOPE * 0.1 * Y
# x is in proportion to delta_alpha, both to epsilon and to 1 / mass_bar; tanh(3 mu) at 0.3.
MU = 0.01 * X * 0.9 * (1.0 / np.tanh(0.9) - np.tanh(0.9))
EXPECTED = [0.01 * X, 0.01 * np.hypot(X, Y), 0.01 * np.hypot(X, Y), MU]


class NoSlopes(MadeUpSimulator):
    def slopes(self, designs: object) -> None:
        raise ParameterError("frame", "elastic", "rigid with sensitivities")


@pytest.mark.parametrize("simulated", [True, False])
@pytest.mark.parametrize("forward", [MadeUpModel(), None])
def test_against_the_closed_form(simulated: bool, forward: MadeUpModel | None) -> None:
    given = problem([X, Y], forward)
    found = one_percent_costs_bar(given, Solution(CONTROLS, np.array([X, Y]), simulated))
    np.testing.assert_allclose(found, EXPECTED, rtol=1e-12)
    asked = given.simulator.simulations
    assert asked == (1 if simulated or forward is None else 0)


def test_a_simulator_without_derivatives() -> None:
    solution = Solution(CONTROLS, np.array([X, Y]), True)
    known = one_percent_costs_bar(problem([X, Y], MadeUpModel(), NoSlopes()), solution)
    np.testing.assert_allclose(known, EXPECTED, rtol=1e-12)
    assert np.isnan(one_percent_costs_bar(problem([X, Y], None, NoSlopes()), solution)).all()
