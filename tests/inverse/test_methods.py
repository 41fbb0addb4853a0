"""Every method reaches what can be reached, within bounds and its budget; and what all share."""

from typing import Any

import numpy as np
import pytest
from made_up_maps import MadeUpModel, MadeUpSimulator, folded, problem, straight

from snapjump.checks import ParameterError
from snapjump.inverse.adam import AdamOptions
from snapjump.inverse.base import one_percent_bar, predicted_solutions
from snapjump.inverse.bayesian import BayesianOptions
from snapjump.inverse.finite_difference import FiniteDifferenceOptions
from snapjump.inverse.gauss_newton import GaussNewtonOptions

# With the largest miss (L) of each on these maps, which span some 15 L.
METHODS = {
    GaussNewtonOptions(): 1e-6,
    AdamOptions(): 1e-3,
    BayesianOptions(simulations=28): 0.5,
    FiniteDifferenceOptions(): 0.02,
}
ON_SIMULATOR = [method for method in METHODS if not method.needs_forward]
ON_FORWARD = [method for method in METHODS if method.needs_forward]
DESIGNS = np.array([[0.05, 0.15, 1.0, 0.3], [0.18, 0.28, 1.0, 0.3]])
SHIFT = (0.7, -0.4)


def named(method: Any) -> str:
    return type(method).__module__.rsplit(".", 1)[1]


@pytest.mark.parametrize("method", METHODS, ids=named)
@pytest.mark.parametrize("design", DESIGNS)
def test_solutions_reach_the_target(method, design):
    target = straight(design[None, :])[0]
    given = problem(target, MadeUpModel())
    found = method.solve(given)[0]
    assert found.miss_bar(target) <= METHODS[method]
    np.testing.assert_allclose(straight(given.designs(found.controls[None, :]))[0], found.apex)
    assert found.simulated == (not method.needs_forward)


@pytest.mark.parametrize("method", METHODS, ids=named)
@pytest.mark.parametrize("target", [(60.0, 12.0), (0.0, 0.0)])
def test_bounds_are_respected(method, target):
    given = problem(target, MadeUpModel())
    for found in method.solve(given):
        assert (found.controls >= given.low).all() and (found.controls <= given.high).all()


@pytest.mark.parametrize("method", ON_SIMULATOR, ids=named)
def test_the_simulator_has_the_last_word(method):
    """The forward model is not asked, and not needed."""
    target = straight(DESIGNS[:1])[0] + SHIFT
    given = problem(target, None, MadeUpSimulator(straight, SHIFT))
    (found,) = method.solve(given)
    assert found.miss_bar(target) <= METHODS[method]
    assert np.abs(given.scaled(found.controls) - given.scaled(DESIGNS[0, :2])).max() < 0.08


@pytest.mark.parametrize("method", ON_SIMULATOR, ids=named)
def test_budgets_are_kept(method):
    given = problem([5.0, 10.0])
    method.solve(given)
    assert 16 <= given.simulator.simulations <= method.simulations


@pytest.mark.parametrize("method", ON_SIMULATOR, ids=named)
def test_robots_that_do_not_jump_are_no_solutions(method):
    def half(designs: Any) -> Any:
        return np.where(designs[:, 1:2] > 0.2, straight(designs), np.nan)

    target = straight(DESIGNS[1:])[0]
    (found,) = method.solve(problem(target, None, MadeUpSimulator(half)))
    assert np.isfinite(found.apex).all() and found.miss_bar(target) < 1.0
    (nothing,) = method.solve(problem(target, None, MadeUpSimulator(half, (np.nan, np.nan))))
    assert np.isfinite(nothing.controls).all()


@pytest.mark.parametrize("method", METHODS, ids=named)
def test_the_same_seed_gives_the_same_answer(method):
    first, second = (method.solve(problem([8.0, 12.0], MadeUpModel()))[0] for _ in range(2))
    np.testing.assert_array_equal(first.controls, second.controls)


@pytest.mark.parametrize("method", ON_FORWARD, ids=named)
def test_a_map_that_folds_has_two_solutions(method):
    target = folded(np.array([[0.07, 0.24, 1.0, 0.3]]))[0]
    found = method.solve(problem(target, MadeUpModel(folded)))
    controls = [solution.controls for solution in found]
    np.testing.assert_allclose(controls, [[0.07, 0.24], [0.13, 0.24]], atol=1e-4)


def test_gauss_newton_finds_a_root_that_its_grid_does_not_make_out():
    """The target lies on the fold, beyond the chord of a coarse grid."""
    target = folded(np.array([[0.1, 0.24, 1.0, 0.3]]))[0] - [1e-3, 0.0]
    found = GaussNewtonOptions(points=4).solve(problem(target, MadeUpModel(folded)))
    assert found[0].miss_bar(target) < 1e-4


@pytest.mark.parametrize("method", ON_FORWARD, ids=named)
def test_methods_that_ask_the_forward_model_need_it(method):
    with pytest.raises(ParameterError, match=f"inverse = '{named(method)}'"):
        method.solve(problem([5.0, 10.0]))


def test_shares_and_back():
    given = problem([5.0, 10.0])
    controls = np.array([[0.01, 0.3], [0.1, 0.2], [0.19, 0.1]])
    shares = given.scaled(controls)
    np.testing.assert_allclose(shares, [[0.0, 1.0], [0.5, 0.5], [1.0, 0.0]], atol=1e-15)
    np.testing.assert_allclose(given.unscaled(shares), controls, atol=1e-15)


def test_a_grid_has_the_corners():
    grid = problem([5.0, 10.0]).grid(3)
    assert grid.shape == (3, 3, 2)
    np.testing.assert_allclose(grid[2, 0], [0.19, 0.1])
    np.testing.assert_allclose(grid[0, 2], [0.01, 0.3])


def test_one_percent_of_what_is_added_is_one_percent_of_it():
    designs = np.array([[0.1, 0.2, 1.0, -0.5]])
    slopes = np.zeros((1, 2, 4))
    slopes[0, :, 0] = 3.0, 4.0
    slopes[0, 1, 3] = 2.0
    np.testing.assert_allclose(one_percent_bar(designs, slopes), [[0.005, 0.0, 0.0, 0.01]])


def test_solutions_are_different_and_reach_the_target():
    model = MadeUpModel(folded)
    target = folded(np.array([[0.06, 0.2, 1.0, 0.3]]))[0]
    controls = np.array([[0.14, 0.2], [0.06, 0.2], [0.06 + 1e-6, 0.2], [0.1, 0.2]])
    found = predicted_solutions(problem(target, model), model, controls)
    # The larger mismatch moves more with one percent of it.
    np.testing.assert_allclose([s.controls for s in found], [[0.06, 0.2], [0.14, 0.2]], atol=1e-5)


def test_of_none_that_reaches_it_there_is_the_nearest():
    model = MadeUpModel()
    controls = np.array([[0.1, 0.2], [0.1, 0.3], [0.1, 0.1]])
    (found,) = predicted_solutions(problem([0.0, 100.0], model), model, controls)
    np.testing.assert_array_equal(found.controls, [0.1, 0.3])


def test_a_design_that_is_tried_again_is_no_news(capfd):
    """A target far beyond a corner, for which it is suggested over and over."""
    given = problem((60.0, 12.0), MadeUpModel())
    BayesianOptions(simulations=40).solve(given)
    assert capfd.readouterr().out == ""
