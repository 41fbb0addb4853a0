"""Regions and costs of one percent, against maps that are known in closed form."""

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpModel, folded, problem

from snapjump.targets.region import AchievableRegion, SimulatedRegion, filled_outline

RANDOM = np.random.default_rng(3)
LOW, HIGH = 0.1 * HEIGHT, 0.3 * HEIGHT  # of y at mass_bar = 1
LEFT, RIGHT = 0.01 * SLOPE, 0.19 * SLOPE  # of x / y


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


def test_its_area_and_its_boundary_which_belongs_to_it():
    found = region()
    corners = found.apexes[[0, 0, -1, -1], [0, -1, 0, -1]]
    np.testing.assert_allclose(corners[0], [LEFT * LOW, LOW])
    assert found.contains(corners).all()
    area = 0.5 * (RIGHT - LEFT) * (HIGH**2 - LOW**2)
    assert found.outline().area == pytest.approx(area, rel=1e-9)


def test_a_folded_map_is_counted_once():
    """Its area is that of the half beyond the fold."""
    half = 0.5 * 40.0 * 0.09**2 * (HIGH**2 - LOW**2)
    found = region(81, MadeUpModel(folded)).outline()
    assert found.area == pytest.approx(half, rel=1e-3)


def test_an_apex_that_is_missing_leaves_a_hole_at_the_edge():
    apexes = grid(4.0, 0.0, 4.0)
    assert filled_outline(apexes).area == pytest.approx(16.0)
    apexes[0, 0] = np.nan
    assert filled_outline(apexes).area == pytest.approx(15.5)  # without that triangle's half
    apexes[2, 2] = np.nan
    assert filled_outline(apexes).area == pytest.approx(15.5), "holes are filled"


def grid(width: float, low: float, high: float) -> np.ndarray:
    """Apexes (5, 5, 2) in a rectangle."""
    sides = np.linspace(0.0, width, 5), np.linspace(low, high, 5)
    return np.stack(np.meshgrid(*sides, indexing="ij"), axis=-1)


def rectangle(width: float, low: float, high: float) -> SimulatedRegion:
    return SimulatedRegion(1.0, 0.3, *[grid(width, low, high)] * 2)


def test_a_simulated_region_that_is_a_rectangle():
    found = rectangle(3.0, 2.0, 6.0)
    assert found.outline.area == found.learned.area == pytest.approx(12.0)
    assert found.extent == (3.0, 4.0) and found.largest_x == 3.0
    assert (found.least_y, found.largest_y) == (2.0, 6.0)
    assert found.width_bar(4.0) == pytest.approx(3.0) and found.width_bar(7.0) == 0.0
    assert found.cone_share == pytest.approx(3.0 / (2 * 0.3 * 2.0))
    assert found.held(rectangle(1.5, 0.0, 8.0)) == pytest.approx(0.5)
