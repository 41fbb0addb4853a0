"""Models of many robots in one array are the models that it was made of."""

import numpy as np
import pytest
from robots import DESIGNS, small_model, small_simulation

from snapjump.engine.model import numbers_of
from snapjump.engine.models import Models

MODELS = [small_model(small_simulation(*design)) for design in DESIGNS[:4]]
pytestmark = pytest.mark.exact  # which numbers that are shaken twice are not


def test_each_is_what_it_was():
    found = Models.of(MODELS)
    assert list(found) == MODELS and len(found) == 4 and found[-1] == MODELS[-1]
    assert Models.of(found) is found and not Models.of([])
    assert np.array_equal(found.numbers, [numbers_of(model) for model in MODELS])
    assert [type(part) for part in found[0]] == [type(part) for part in MODELS[0]]


def test_some_of_them_and_more():
    found = Models.of(MODELS)
    assert list(found[1:3]) == MODELS[1:3]
    assert list(found[np.array([3, 0])]) == [MODELS[3], MODELS[0]]
    assert list(found[:2].followed_by(MODELS[2:])) == MODELS
    assert list(found.followed_by([])) == MODELS


def test_one_model_of_columns():
    frame = MODELS[0].frame._replace(mass=np.array([2.0, 3.0]))
    found = Models.of_columns(MODELS[0]._replace(frame=frame), 2)
    expected = [MODELS[0]._replace(frame=frame._replace(mass=mass)) for mass in (2.0, 3.0)]
    assert list(found) == expected
