"""Robust designs: distributions against closed forms, and where allowing for errors must help."""

from typing import Any

import numpy as np
import pytest
from made_up_maps import HEIGHT, RANGES, MadeUpModel, folded, problem, straight

from snapjump.inverse.base import Solution
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.targets.robust import Tolerance, built, compare, scatter, sobol_points

NONE = {"delta_alpha_rad": 0.0, "epsilon": 0.0, "mass_bar": 0.0, "mu": 0.0}
CONTROLS = np.array([0.1, 0.2])


def test_a_normal_error_along_a_line():
    """Both coordinates are in proportion to epsilon: the miss is a half normal one."""
    target = straight(np.array([[*CONTROLS, 1.0, 0.3]]))[0]
    model, tolerance = MadeUpModel(), Tolerance(**{**NONE, "epsilon": 0.002})
    found = scatter(problem(target, model), model, tolerance, CONTROLS)
    sigma = 0.002 / 0.2 * target
    np.testing.assert_allclose(found.mean, target, rtol=1e-4)
    np.testing.assert_allclose(found.deviation, sigma, rtol=5e-3)
    size = np.hypot(*sigma)
    assert found.expected_miss_bar == pytest.approx(np.sqrt(2.0 / np.pi) * size, rel=5e-3)
    assert found.radius90_bar == pytest.approx(1.6449 * size, rel=1e-2)


def test_without_tolerances_there_is_no_scatter():
    model = MadeUpModel()
    found = scatter(problem([8.0, 12.0], model), model, Tolerance(**NONE), CONTROLS)
    assert found.deviation.max() < 1e-9
    assert found.radius90_bar == pytest.approx(found.expected_miss_bar)


def test_robots_stay_within_the_ranges_and_their_tolerances_normal_there():
    low, high = np.array(RANGES).T
    tolerance = Tolerance(0.05, 0.05, 1.0, 0.3)
    model = MadeUpModel()
    designs = built(problem([8.0, 12.0], model), model, tolerance, CONTROLS, sobol_points(4096, 1))
    assert (designs >= low).all() and (designs <= high).all()
    # delta_alpha 0.1 +- 0.05 between 0.01 and 0.19: symmetrically cut at 1.8 deviations, where
    # the variance is 1 - 2 z phi(z) / (2 Phi(z) - 1) = 0.693.
    assert designs[:, 0].mean() == pytest.approx(0.1, abs=1e-4)
    assert designs[:, 0].std() == pytest.approx(0.05 * np.sqrt(0.6935), rel=2e-3)


def far(designs: Any) -> Any:
    """Folded at delta_alpha = 0.1 rad, where it reaches twice as far as high."""
    y = HEIGHT * designs[:, 1] / designs[:, 2]
    return np.stack([y * (2.0 - 40.0 * (designs[:, 0] - 0.1) ** 2), y], axis=1)


def test_on_a_fold_the_robust_design_is_better():
    """Every error of delta_alpha shortens the jump that goes farthest: some more compression, which
    reaches farther and higher, lessens the expected miss to first order."""
    model = MadeUpModel(far)
    target = far(np.array([[0.1, 0.2, 1.0, 0.3]]))[0]
    given = problem(target, model)
    tolerance = Tolerance(**{**NONE, "delta_alpha_rad": 0.03})
    plain = [Solution(CONTROLS, target, False)]
    found = compare(given, tolerance, plain)
    ours, theirs = expected(found.robust.controls, target), expected(CONTROLS, target)
    assert ours < 0.95 * theirs
    assert found.robust_scatter.expected_miss_bar == pytest.approx(ours, rel=0.02)
    assert found.plain_scatter.expected_miss_bar == pytest.approx(theirs, rel=0.02)
    assert found.robust.controls[1] > 0.2
    assert found.robust.miss_bar(target) > 0.01


def expected(controls: Any, target: Any) -> float:
    """The expected miss on the fold, by random numbers that are drawn again until in range."""
    drawn = np.random.default_rng(5).normal(controls[0], 0.03, 200_000)
    drawn = drawn[(drawn >= 0.01) & (drawn <= 0.19)]
    rest = np.tile([controls[1], 1.0, 0.3], (len(drawn), 1))
    apexes = far(np.hstack([drawn[:, None], rest]))
    return float(np.hypot(*(apexes - target).T).mean())


def test_of_several_solutions_it_takes_the_less_sensitive_branch():
    """Beyond the fold the apex depends on mu as well, which varies."""
    model = MadeUpModel(folded)
    target = folded(np.array([[0.06, 0.2, 1.0, 0.3]]))[0]
    given = problem(target, model)
    solutions = GaussNewtonOptions().solve(given)[::-1]
    assert solutions[0].controls[0] == pytest.approx(0.14)
    found = compare(given, Tolerance(**{**NONE, "mu": 0.1}), solutions)
    assert found.robust.controls[0] < 0.1
    assert found.robust_scatter.expected_miss_bar < 1e-3 < found.plain_scatter.expected_miss_bar


def test_the_same_seed_gives_the_same_design():
    model = MadeUpModel()
    given = problem([0.4 * 0.1 * 12.0, HEIGHT * 0.2], model)
    solutions = GaussNewtonOptions().solve(given)
    first, second = (compare(given, Tolerance(), solutions) for _ in range(2))
    np.testing.assert_array_equal(first.robust.controls, second.robust.controls)
