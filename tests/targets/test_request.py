"""What users ask for, the one line where they may not, and designs against jumps on their own."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from made_up_maps import MadeUpModel
from refusals import refused

from snapjump import Design, Environment, ParameterError, simulate_jump
from snapjump.declare.fields import construct
from snapjump.inverse.bayesian import BayesianOptions
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.learning import STANDARD
from snapjump.targets.design import inverse_design
from snapjump.targets.request import checked_target, checkpoint_path, usable_forward
from snapjump.targets.robust import Tolerance

TOLERANCE = {"delta_alpha_rad": 0.002, "epsilon": 0.001, "mass_bar": 0.01, "mu": 0.02}


def test_what_is_asked_for_is_given():
    np.testing.assert_array_equal(checked_target([5, 14.5]), [5.0, 14.5])
    np.testing.assert_array_equal(checked_target((-1.0, 0.0)), [-1.0, 0.0])
    assert construct("tolerance", Tolerance, TOLERANCE) == Tolerance()
    assert checkpoint_path(None) == STANDARD
    assert str(checkpoint_path("a/b.safetensors")) == "a/b.safetensors"


BAD_TARGETS = (
    None, "5,14", "ab", 5.0, [], [5.0], [5.0, 14.0, 1.0], {"x": 5.0, "y": 14.0},
    [5.0, float("nan")], [float("inf"), 14.0], [5.0, -0.1], ["5", 14.0], [True, 14.0],
    [None, 14.0], [[5.0, 14.0], 1.0], [10**400, 1.0],
)  # fmt: skip


@pytest.mark.parametrize("value", BAD_TARGETS)
def test_bad_targets(value):
    with refused("target"):
        checked_target(value)


def test_bad_tolerances():
    for group, key in (
        (None, "tolerance"), (0.1, "tolerance"), ({**TOLERANCE, "mu": -1.0}, "tolerance.mu"),
        ({**TOLERANCE, "width_m": 0.1}, "tolerance.width_m"),
    ):  # fmt: skip
        with refused(key):
            construct("tolerance", Tolerance, group)


@pytest.mark.parametrize("value", ["", 3, False, ["a"]])
def test_bad_checkpoints(value):
    with refused("checkpoint"):
        checkpoint_path(value)


class OfAnotherModel(MadeUpModel):
    def check_model(self, simulation: Any) -> None:
        raise ParameterError("damping.name", "none", "'kelvin_voigt'")


# mu and mass_bar; a forward model; the key that is at fault, and what may be
UNUSABLE = (
    (0.601, 1.0, MadeUpModel(), "environment.mu", "[0."),
    (0.099, 1.0, MadeUpModel(), "environment.mu", "[0."),
    (0.3, 2.01, MadeUpModel(), "environment.mass_bar", "[0."),
    (0.9, 0.2, MadeUpModel(), "environment.mass_bar", "[0."),
    (0.3, 1.0, OfAnotherModel(), "damping.name", "'kelvin_voigt'"),
)


def in_environment(mu: float, mass_bar: float) -> Any:
    return SimpleNamespace(environment=SimpleNamespace(mu=mu, mass_bar=mass_bar))


@pytest.mark.parametrize(("mu", "mass_bar", "model", "key", "allowed"), UNUSABLE)
def test_forward_models_out_of_range_or_of_another_robot(mu, mass_bar, model, key, allowed):
    base = in_environment(mu, mass_bar)
    for method in (GaussNewtonOptions(), BayesianOptions(robust=True)):
        with refused(key, allowed):
            usable_forward(base, model, method)
    forward, warning = usable_forward(base, model, BayesianOptions())
    assert forward is None and key in warning and "\n" not in warning


@pytest.mark.parametrize("method", [GaussNewtonOptions(), BayesianOptions()])
def test_environments_on_its_edge(method):
    model = MadeUpModel()
    assert usable_forward(in_environment(0.6, 0.3), model, method) == (model, "")


ENVIRONMENT = Environment(mu=0.25, mass_bar=0.9)


def simulated_alone(found: Any) -> Any:
    """The jump of the best design."""
    delta_alpha, epsilon = found.solutions[0].controls.tolist()
    return simulate_jump(design=Design(epsilon, delta_alpha), environment=ENVIRONMENT)


def test_a_design_reaches_its_target_when_it_is_simulated_alone():
    found = inverse_design((3.0, 12.0), ENVIRONMENT)
    assert found.reachable
    jump = simulated_alone(found)
    assert found.solutions[0].apex == pytest.approx([jump.x_bar, jump.y_bar], abs=1e-12)
    assert np.hypot(jump.x_bar - 3.0, jump.y_bar - 12.0) < 3e-4


def test_the_model_that_comes_along_is_as_good_as_it_says():
    found = inverse_design((3.0, 12.0), ENVIRONMENT, method=GaussNewtonOptions())
    jump = simulated_alone(found)
    # Ten times the mean error that it was measured to have.
    assert np.hypot(jump.x_bar - 3.0, jump.y_bar - 12.0) < 0.12
    assert found.simulations == 1


def test_out_of_reach():
    found = inverse_design((30.0, 2.0), ENVIRONMENT)
    assert found.reachable is False and found.simulations > 0
    np.testing.assert_allclose(found.searched, [[-0.19, 0.19], [0.1, 0.3]])


def test_outside_of_the_training_range():
    heavy = Environment(mu=0.25, mass_bar=2.5)
    with pytest.raises(ParameterError, match="mass_bar"):
        inverse_design((1.0, 5.0), heavy, method=GaussNewtonOptions())
    with pytest.warns(UserWarning, match="goes on without it"):
        found = inverse_design((1.0, 5.0), heavy, "draft")
    assert found.reachable
    assert found.solutions[0].miss_bar(np.array([1.0, 5.0])) < 3e-4


@pytest.mark.parametrize(
    "bad", [{"target": (3.0, -1.0)}, {"accuracy": "perfect"}, {"checkpoint": "nowhere"}]
)
def test_bad_input_is_named(bad):
    with refused(*bad):
        inverse_design(**{"target": (3.0, 12.0), **bad})
