"""Answers to targets: reached, not reached and unreachable by simulation, on both sides."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpModel, MadeUpSimulator, folded, problem, straight

from snapjump.inverse.finite_difference import FiniteDifferenceOptions
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.inverse.physics import PhysicsOptions
from snapjump.targets.answer import answer
from snapjump.targets.mirror import Between, Mirrored, with_mirror

HIGH = 0.3 * HEIGHT  # of y at mass_bar = 1
CORNER = np.array([0.19 * SLOPE * HIGH, HIGH])
ALL = [[-0.19, 0.19], [0.1, 0.3]]


def test_a_target_that_is_reached_and_simulated():
    given = problem([5.0, 10.0], MadeUpModel())
    found = answer(given, GaussNewtonOptions())
    assert found.reachable is True and found.simulations == 1 and found.problem is given
    np.testing.assert_allclose(found.solutions[0].controls, [0.5 / SLOPE, 10.0 / HEIGHT], rtol=1e-6)
    assert found.solutions[0].simulated
    np.testing.assert_allclose(found.searched, [[0.01, 0.19], [0.1, 0.3]])


@pytest.mark.parametrize(
    ("method", "reachable"),
    [(PhysicsOptions(), False), (FiniteDifferenceOptions(), False), (GaussNewtonOptions(), None)],
)
def test_a_target_that_no_design_reaches(method, reachable):
    given = problem(CORNER + [1.0, 2.0], MadeUpModel())
    found = answer(given, method)
    assert found.reachable is reachable and found.solutions[0].simulated
    np.testing.assert_allclose(found.solutions[0].controls, [0.19, 0.3], rtol=1e-3)
    np.testing.assert_allclose(found.solutions[0].apex, CORNER, rtol=1e-3)
    np.testing.assert_allclose(found.searched, ALL)
    assert found.simulations == given.simulator.simulations > 0


def test_the_forward_model_does_not_decide():
    """It sees the target out of reach, by ten times its margin of before."""
    given = problem(CORNER, MadeUpModel(lambda designs: straight(designs) * [0.95, 0.95]))
    found = answer(given, PhysicsOptions())
    assert found.reachable and found.solutions[0].miss_bar(CORNER) < 1e-3


def test_a_prediction_that_misses_is_not_reached_and_never_unreachable():
    given = problem([5.0, 10.0], MadeUpModel(), MadeUpSimulator(straight, (0.2, 0.0)))
    found = answer(given, GaussNewtonOptions())
    assert found.reachable is None
    assert found.solutions[0].apex == pytest.approx([5.2, 10.0], abs=1e-3)
    assert answer(given, PhysicsOptions()).reachable is True


def test_another_prediction_may_be_the_one_that_hits():
    """The map folds; the simulator knows only the half beyond the fold."""

    def half(designs):
        near = designs[:, :1] < 0.1
        return np.where(near, folded(designs) + 1.0, folded(designs))

    target = folded(np.array([[0.06, 0.2, 1.0, 0.3]]))[0]
    found = answer(
        problem(target, MadeUpModel(folded), MadeUpSimulator(half)), GaussNewtonOptions()
    )
    assert found.reachable and found.solutions[0].controls[0] == pytest.approx(0.14, abs=1e-4)
    assert len(found.solutions) == 2


@pytest.mark.parametrize("method", [PhysicsOptions(), GaussNewtonOptions()])
@pytest.mark.parametrize("forward", [MadeUpModel(), None])
@pytest.mark.parametrize("x", [-5.0, -0.2, 0.1])
def test_the_mirror_image_is_searched(method, forward, x):
    if forward is None and method.needs_forward:
        return
    given = problem([x, 10.0], forward)
    found = answer(given, method)
    assert found.reachable
    np.testing.assert_allclose(
        found.solutions[0].controls, [x / 10.0 / SLOPE, 10.0 / HEIGHT], atol=1e-4
    )
    low, high = found.problem.low, found.problem.high
    assert ((low <= found.solutions[0].controls) & (found.solutions[0].controls <= high)).all()


def test_on_a_slope_the_mirror_image_is_simulated_and_not_believed():
    given = replace(problem([-5.0, 10.0], MadeUpModel()), symmetric=False)
    assert [side.forward is None for side in with_mirror(given)] == [True, False, True]
    assert answer(given, PhysicsOptions()).reachable


def test_ranges_that_are_their_own_mirror_image_are_searched_once():
    given = replace(problem([5.0, 10.0], None), low=np.array([-0.19, 0.1]))
    assert with_mirror(given) == [given]


@pytest.mark.parametrize("wrap", [Mirrored, Between])
def test_mirrored_models_agree_with_the_map_and_their_derivatives_with_differences(wrap):
    model = wrap(MadeUpModel())
    low, high = np.array(model.ranges).T
    designs = low + (high - low) * np.random.default_rng(0).uniform(0.1, 0.9, (20, 4))
    np.testing.assert_allclose(model.predict(designs), straight(designs), rtol=1e-12)
    step = 1e-6
    for k in range(4):
        moved = step * np.eye(4)[k]
        slope = (model.predict(designs + moved) - model.predict(designs - moved)) / (2.0 * step)
        np.testing.assert_allclose(model.jacobian(designs)[:, :, k], slope, rtol=1e-6, atol=1e-6)


def test_without_a_forward_model_the_miss_decides():
    target = straight(np.array([[0.07, 0.2, 3.0, 0.3]]))[0]
    given = problem(target, None, MadeUpSimulator(), mass_bar=3.0)
    method = FiniteDifferenceOptions()
    found = answer(given, method)
    assert found.reachable and found.simulations == given.simulator.simulations > 0
    assert not answer(replace(given, target=target + 20.0), method).reachable


def test_what_does_not_jump_at_all():
    given = problem([5.0, 10.0], MadeUpModel(), MadeUpSimulator(straight, (np.nan, np.nan)))
    for method, reachable in ((PhysicsOptions(most_simulations=16), False),
                              (GaussNewtonOptions(), None)):  # fmt: skip
        found = answer(given, method)
        assert found.reachable is reachable and not np.isfinite(found.solutions[0].apex).any()
