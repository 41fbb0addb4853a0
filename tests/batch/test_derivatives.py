"""Derivatives of a model's numbers against differences through directly computed thresholds."""

from dataclasses import replace

import numpy as np
import pytest

from snapjump.batch import model_derivatives, variant
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.engine.model import numbers_of
from snapjump.parameters.robot import Robot
from snapjump.scenes.jump_start import jump_model
from snapjump.statics.threshold_curve import ThresholdCurve

BASE = with_tier("draft")
DESIGNS = ((0.1, 0.2, 0.768, 0.3), (-0.19, 0.11, 2.0, 0.1), (0.45, 0.29, 0.3, 0.6))
# Of delta_alpha, epsilon, mass_bar, mu: as large as rounding and direct thresholds ask for.
STEPS = (1e-2, 8e-3, 1e-2, 1e-2)


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.09, 0.31)


def richardson(base, design):
    """Central differences of the direct path at h, h/2 and h/4, extrapolated to order 6."""

    def difference(k, step):
        ahead, behind = np.array(design), np.array(design)
        ahead[k] += step
        behind[k] -= step
        numbers = [numbers_of(jump_model(variant(base, one))) for one in (ahead, behind)]
        return (numbers[0] - numbers[1]) / (2.0 * step)

    columns = []
    for k, step in enumerate(STEPS):
        coarse, middle, fine = (difference(k, step / share) for share in (1, 2, 4))
        first, second = (4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0
        columns.append((16.0 * second - first) / 15.0)
    return np.array(columns).T


@pytest.mark.parametrize("design", DESIGNS)
@pytest.mark.parametrize("mount_height", ["optimal", "fitted"])
def test_against_direct_differences(design, mount_height, curve):
    base = replace(BASE, robot=replace(BASE.robot, mount_height=mount_height))
    found = model_derivatives(base, design, curve)
    expected = richardson(base, design)
    scale = np.maximum(np.abs(numbers_of(jump_model(variant(base, design)))), 1.0)[:, None]
    assert found.shape == (len(scale), 4)
    np.testing.assert_allclose(found / scale, expected / scale, atol=1e-6)


def test_numbers_that_do_not_depend_on_the_design_have_no_derivative(curve):
    found = model_derivatives(BASE, DESIGNS[0], curve)
    model = jump_model(variant(BASE, DESIGNS[0]))
    rod = len(model.discretization)
    assert (found[:rod] == 0.0).all()
    # mu is one number of the friction law; delta_alpha one of the clamps.
    assert np.flatnonzero(found[:, 3]).tolist() == [rod + 6 + 4 + len(model.contact)]
    assert np.flatnonzero(found[:, 0]).tolist() == [rod + 6 + 3]


@pytest.mark.parametrize(
    "design", [(0.0, 0.2, 0.768, 0.0), (0.5, 0.31, 0.3, 0.1), (-0.5, 0.09, 0.3, 0.1)]
)
def test_at_the_ends_of_the_ranges(design, curve):
    assert np.isfinite(model_derivatives(BASE, design, curve)).all()


def test_the_kink_where_the_clamps_change_places(curve):
    """The left clamp starts later by what it lags, but not earlier by what it leads."""
    model = jump_model(variant(BASE, DESIGNS[0]))
    start = len(model.discretization) + len(model.frame)
    lags = model_derivatives(BASE, (-1e-9, *DESIGNS[0][1:]), curve)[start, 0]
    leads = model_derivatives(BASE, (0.0, *DESIGNS[0][1:]), curve)[start, 0]
    assert leads == 0.0
    assert lags == pytest.approx(1.0, rel=1e-9)


def test_refusals(curve):
    with pytest.raises(ParameterError, match="design.epsilon = 0.32"):
        model_derivatives(BASE, (0.1, 0.32, 0.768, 0.3), curve)
    with pytest.raises(ParameterError, match="curve = "):
        model_derivatives(replace(BASE, robot=Robot(length_m=0.03)), DESIGNS[0], curve)
