"""The front door of inverse design, against jumps on their own."""

from typing import Any

import numpy as np
import pytest
from refusals import refused

from snapjump import Design, Environment, ParameterError, simulate_jump
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.targets.design import design_for

ENVIRONMENT = Environment(mu=0.25, mass_bar=0.9)


def simulated_alone(found: Any) -> Any:
    """The jump of the best design."""
    delta_alpha, epsilon = found.solutions[0].controls.tolist()
    return simulate_jump(design=Design(epsilon, delta_alpha), environment=ENVIRONMENT)


def test_a_design_reaches_its_target_when_it_is_simulated_alone():
    found = design_for((3.0, 12.0), ENVIRONMENT)
    assert found.reachable
    jump = simulated_alone(found)
    assert found.solutions[0].apex == pytest.approx([jump.x_bar, jump.y_bar], abs=1e-12)
    assert np.hypot(jump.x_bar - 3.0, jump.y_bar - 12.0) < 3e-4


def test_the_model_that_comes_along_is_as_good_as_it_says():
    found = design_for((3.0, 12.0), ENVIRONMENT, method=GaussNewtonOptions())
    jump = simulated_alone(found)
    # Ten times the mean error that it was measured to have.
    assert np.hypot(jump.x_bar - 3.0, jump.y_bar - 12.0) < 0.12
    assert found.simulations == 0


def test_out_of_reach():
    found = design_for((30.0, 2.0), ENVIRONMENT)
    assert not found.reachable
    assert found.simulations == 0


def test_outside_of_the_training_range():
    heavy = Environment(mu=0.25, mass_bar=2.5)
    with pytest.raises(ParameterError, match="mass_bar"):
        design_for((1.0, 5.0), heavy, method=GaussNewtonOptions())
    with pytest.warns(UserWarning, match="goes on without it"):
        found = design_for((1.0, 5.0), heavy, "draft")
    assert found.reachable
    assert found.solutions[0].miss_bar(np.array([1.0, 5.0])) < 3e-4


@pytest.mark.parametrize(
    ("target", "options", "key"),
    [
        ((3.0, -1.0), {}, "target"),
        ((3.0, 12.0), {"accuracy": "perfect"}, "accuracy"),
        ((3.0, 12.0), {"checkpoint": "nowhere"}, "checkpoint"),
    ],
)
def test_bad_input_is_named(target, options, key):
    with refused(key):
        design_for(target, **options)
