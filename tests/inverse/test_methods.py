"""Every method reaches what can be reached, stays within the bounds and keeps to its budget."""

from typing import Any

import numpy as np
import pytest
from made_up_maps import MadeUpModel, MadeUpSimulator, folded, problem, straight

from snapjump.checks import ParameterError
from snapjump.inverse.adam import AdamOptions
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


@pytest.mark.parametrize("method", [GaussNewtonOptions(), AdamOptions()], ids=named)
def test_a_map_that_folds_has_two_solutions(method):
    target = folded(np.array([[0.07, 0.24, 1.0, 0.3]]))[0]
    found = method.solve(problem(target, MadeUpModel(folded)))
    controls = [solution.controls for solution in found]
    np.testing.assert_allclose(controls, [[0.07, 0.24], [0.13, 0.24]], atol=1e-4)


def test_gauss_newton_finds_a_root_that_its_grid_does_not_make_out():
    """Beyond the chord of a coarse grid, on the fold."""
    target = folded(np.array([[0.1, 0.24, 1.0, 0.3]]))[0] - [1e-3, 0.0]
    found = GaussNewtonOptions(points=4).solve(problem(target, MadeUpModel(folded)))
    assert found[0].miss_bar(target) < 1e-4


@pytest.mark.parametrize("cls", [GaussNewtonOptions, AdamOptions])
def test_methods_that_ask_the_forward_model_need_it(cls):
    with pytest.raises(ParameterError, match="inverse = "):
        cls().solve(problem([5.0, 10.0]))
