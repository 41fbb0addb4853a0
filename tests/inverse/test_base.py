"""What all methods share: bounds as shares, one percent, different solutions."""

import numpy as np
import pytest
from made_up_maps import MadeUpModel, folded, problem

from snapjump.checks import ParameterError
from snapjump.inverse.base import one_percent_bar, predicted_solutions


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
    found = predicted_solutions(
        problem(target, model),
        model,
        np.array([[0.14, 0.2], [0.06, 0.2], [0.06 + 1e-6, 0.2], [0.1, 0.2]]),
    )
    # The larger mismatch moves more with one percent of it.
    np.testing.assert_allclose([s.controls for s in found], [[0.06, 0.2], [0.14, 0.2]], atol=1e-5)


def test_of_none_that_reaches_it_there_is_the_nearest():
    model = MadeUpModel()
    (found,) = predicted_solutions(
        problem([0.0, 100.0], model), model, np.array([[0.1, 0.2], [0.1, 0.3], [0.1, 0.1]])
    )
    np.testing.assert_array_equal(found.controls, [0.1, 0.3])


def test_without_a_forward_model_a_method_that_asks_it_is_refused():
    with pytest.raises(ParameterError, match="inverse = 'adam'"):
        problem([5.0, 10.0]).known_forward("adam")
