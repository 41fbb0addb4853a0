"""inverse.png: with and without a forward model, of several solutions, robust, out of reach."""

from pathlib import Path

import numpy as np
import pytest
from forward_models import about
from made_up_maps import MadeUpModel, folded, problem
from pictures import has, picture

from snapjump.inverse.base import Solution
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.show.plots import palette
from snapjump.show.plots.achievable import compound
from snapjump.show.plots.inverse import inverse_picture
from snapjump.targets.answer import Answer, answer
from snapjump.targets.designed import Designed
from snapjump.targets.manufacturing import OnePercent
from snapjump.targets.region import AchievableRegion
from snapjump.targets.robust import Tolerance, compare

MODEL = MadeUpModel(folded)
TARGET = folded(np.array([[0.06, 0.2, 1.0, 0.3]]))[0]


def drawn(designed: Designed, region: AchievableRegion | None, folder: Path) -> np.ndarray:
    return picture(inverse_picture(designed, region, folder / "inverse.png"))


def shows(pixels: np.ndarray, colour: str) -> bool:
    return has(pixels, colour, 40)


@pytest.mark.parametrize("target", [TARGET, TARGET + 30.0])
def test_region_solutions_and_flight(jump, tmp_path, target):
    given = problem(target, MODEL)
    found = answer(given, GaussNewtonOptions())
    designed = Designed(found, found.solutions[0], OnePercent({}), jump, None, about(), "")
    picture = drawn(designed, AchievableRegion.of(given, MODEL), tmp_path)
    for colour in (palette.BEAM, palette.PLUM, palette.CENTRE, palette.FORCE, palette.INK):
        assert shows(picture, colour)
    assert not shows(picture, palette.CLAMP)


def test_a_robust_design_has_clouds(jump, tmp_path):
    given = problem(TARGET, MODEL)
    found = answer(given, GaussNewtonOptions())
    robust = compare(found.problem, Tolerance(), found.solutions)
    designed = Designed(found, robust.robust, OnePercent({}), jump, robust, about(), "")
    picture = drawn(designed, AchievableRegion.of(given, MODEL), tmp_path)
    assert shows(picture, palette.CLAMP)
    assert picture.shape[0] > 1000


def test_without_a_forward_model(jump, tmp_path):
    solutions = [Solution(np.array([0.1, 0.2]), TARGET, True)]
    found = Answer(True, solutions, problem(TARGET), np.zeros((2, 2)), 1.0, 60)
    designed = Designed(found, found.solutions[0], OnePercent({}), jump, None, about(), "")
    picture = drawn(designed, None, tmp_path)
    assert shows(picture, palette.CENTRE) and not shows(picture, palette.PLUM)


def test_holes_run_the_other_way_round():
    """So they are not filled, and the areas within all rings add up to that of the geometry."""
    import shapely

    ring = shapely.Point(0.0, 0.0).buffer(2.0).difference(shapely.Point(0.0, 0.0).buffer(1.0))
    geometry = shapely.union(ring, shapely.box(5.0, 5.0, 6.0, 6.0))
    rings = compound(geometry).to_polygons()
    assert len(rings) == 3
    signed = [0.5 * np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) for x, y in (r.T for r in rings)]
    assert sum(signed) == pytest.approx(geometry.area) and min(signed) < 0.0
