"""Regions, answers and costs of one percent, against maps that are known in closed form."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpModel, MadeUpSimulator, folded, problem, straight

from snapjump.inverse.base import Solution
from snapjump.inverse.finite_difference import FiniteDifferenceOptions
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.targets.answer import BOUNDARY_BAR, answer
from snapjump.targets.designed import one_percent_costs_bar
from snapjump.targets.region import AchievableRegion

RANDOM = np.random.default_rng(3)
LOW, HIGH = 0.1 * HEIGHT, 0.3 * HEIGHT  # of y at m_bar = 1
LEFT, RIGHT = 0.01 * SLOPE, 0.19 * SLOPE  # of x / y
CORNER = np.array([RIGHT * HIGH, HIGH])


def region(points: int = 21, model: MadeUpModel | None = None) -> AchievableRegion:
    model = model or MadeUpModel()
    return AchievableRegion.of(problem([5.0, 10.0], model), model, points)


def inside(targets: np.ndarray) -> np.ndarray:
    """The trapezoid between two heights and two lines through the origin."""
    x, y = targets.T
    return (y >= LOW) & (y <= HIGH) & (x >= LEFT * y) & (x <= RIGHT * y)


@pytest.mark.parametrize("points", [2, 5, 21])
def test_targets_within_a_trapezoid(points):
    targets = RANDOM.uniform([-2.0, 0.0], [16.0, 25.0], (2000, 2))
    assert 300 < inside(targets).sum() < 1700
    np.testing.assert_array_equal(region(points).contains(targets), inside(targets))


def test_its_boundary_belongs_to_it():
    found = region()
    corners = found.apexes[[0, 0, -1, -1], [0, -1, 0, -1]]
    np.testing.assert_allclose(corners[0], [LEFT * LOW, LOW])
    assert found.contains(corners).all()


def test_its_area():
    area = 0.5 * (RIGHT - LEFT) * (HIGH**2 - LOW**2)
    assert region().outline().area == pytest.approx(area, rel=1e-9)


def test_the_nearest_apex_and_its_design():
    found = region()
    # Above: straight down. To the right: at a right angle to the line through the origin.
    controls, apex = found.nearest(np.array([5.0, HIGH + 3.0]))
    np.testing.assert_allclose(apex, [5.0, HIGH], atol=1e-9)
    np.testing.assert_allclose(controls, [5.0 / HIGH / SLOPE, 0.3], atol=1e-9)
    along = np.array([RIGHT, 1.0]) / np.hypot(RIGHT, 1.0)
    edge = 14.0 * along
    controls, apex = found.nearest(edge + 2.0 * np.array([along[1], -along[0]]))
    np.testing.assert_allclose(apex, edge, atol=1e-9)
    np.testing.assert_allclose(controls, [0.19, edge[1] / HEIGHT], atol=1e-9)


def test_a_folded_map_is_counted_once():
    """Its area is that of the half beyond the fold."""
    half = 0.5 * 40.0 * 0.09**2 * (HIGH**2 - LOW**2)
    found = region(81, MadeUpModel(folded)).outline()
    assert found.area == pytest.approx(half, rel=1e-3)


def test_a_map_onto_a_line():
    def line(designs: np.ndarray) -> np.ndarray:
        return np.stack([0.0 * designs[:, 1], HEIGHT * designs[:, 1]], axis=1)

    found = region(5, MadeUpModel(line))
    controls, apex = found.nearest(np.array([3.0, 12.0]))
    np.testing.assert_allclose(apex, [0.0, 12.0], atol=1e-9)
    assert controls[1] == pytest.approx(0.2)


def test_a_target_that_can_be_reached():
    given = problem([5.0, 10.0], MadeUpModel())
    found = answer(given, GaussNewtonOptions())
    assert found.reachable and found.simulations == 0 and 0.0 < found.seconds < 1.0
    controls = found.solutions[0].controls
    np.testing.assert_allclose(controls, [0.5 / SLOPE, 10.0 / HEIGHT], rtol=1e-6)


def test_a_target_that_cannot_be_reached():
    given = problem(CORNER + [1.0, 2.0], MadeUpModel())
    found = answer(given, FiniteDifferenceOptions())
    assert not found.reachable and len(found.solutions) == 1
    np.testing.assert_allclose(found.solutions[0].controls, [0.19, 0.3], rtol=1e-9)
    np.testing.assert_allclose(found.solutions[0].apex, CORNER, rtol=1e-9)
    assert found.simulations == 0


@pytest.mark.parametrize(("beyond", "reachable"), [(0.9, True), (1.1, False)])
def test_a_target_on_the_boundary(beyond, reachable):
    """The forward model's own error is not held against it."""
    given = problem([5.0, HIGH + beyond * BOUNDARY_BAR], MadeUpModel())
    found = answer(given, GaussNewtonOptions())
    assert found.reachable == reachable
    assert found.solutions[0].controls[1] == pytest.approx(0.3)


def test_without_a_forward_model_the_miss_decides():
    target = straight(np.array([[0.07, 0.2, 3.0, 0.3]]))[0]
    given = problem(target, None, MadeUpSimulator(), mass_bar=3.0)
    method = FiniteDifferenceOptions()
    found = answer(given, method)
    assert found.reachable and found.simulations == given.simulator.simulations > 0
    assert not answer(replace(given, target=target + 20.0), method).reachable


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
