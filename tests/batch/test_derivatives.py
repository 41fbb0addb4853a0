"""Derivatives of a model's numbers against differences through directly computed thresholds."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from differences import slope

from snapjump import ParameterError, Robot
from snapjump.batch import model_derivatives, variant
from snapjump.batch.derivatives import place
from snapjump.composition import with_tier
from snapjump.declare.inputs import DEFAULT_INPUTS, inputs_of, with_inputs
from snapjump.engine.model import TimeLimit, numbers_of
from snapjump.scenes.jump_start import (
    critical,
    jump_model,
    leading_start,
    loading_time,
    start_angle_rad,
)
from snapjump.statics.threshold_curve import ThresholdCurve

BASE = with_tier("draft")
DESIGNS = ((0.1, 0.2, 0.768, 0.3), (-0.19, 0.11, 2.0, 0.1), (0.45, 0.29, 0.3, 0.6))
# Of delta_alpha, epsilon, mass_bar, mu: as large as rounding and direct thresholds ask for.
STEPS = (1e-2, 8e-3, 1e-2, 1e-2)
# Every other input at the ends of the range that is declared for plans.
ENDS = [
    (path, end)
    for path, one in inputs_of(BASE).items()
    for end in one.plan or ()
    if path not in (*DEFAULT_INPUTS, "robot.yield_stress_Pa") and end  # which moves nothing
]


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.09, 0.31)


def direct_numbers(base, moved):
    """Numbers of a robot whose start moves along the branch so that its snap comes when that of
    another does, and whose time limit counts from its start."""
    threshold = critical(base)
    loading = loading_time(base, start_angle_rad(base, threshold), threshold)
    model = jump_model(moved)
    clamp = model.clamp._replace(start=leading_start(moved, critical(moved), loading))
    limit = TimeLimit(moved.sim.time_limit_s / moved.robot.scales.time_s)
    return numbers_of(model._replace(clamp=clamp, time_limit=limit))


def direct_slopes(base, design):
    """Derivatives of the numbers that are computed directly."""

    def numbers(axis, change):
        return direct_numbers(variant(base, design), variant(base, design + change * axis))

    columns = [slope(partial(numbers, axis), h) for axis, h in zip(np.eye(4), STEPS, strict=True)]
    return np.array(columns).T


@pytest.mark.parametrize(("path", "value"), ENDS)
def test_any_input_against_direct_differences(path, value, curve):
    """Every number's derivative is right to 1e-6 of the number, and some number depends on it."""
    found = model_derivatives(BASE, np.array([[value]]), curve, (path,))[0, :, 0]

    here = with_inputs(BASE, {path: value})

    def numbers(factor):
        return direct_numbers(here, with_inputs(BASE, {path: value * factor}))

    coarse, fine = ((numbers(1.0 + h) - numbers(1.0 - h)) / (2.0 * h * value) for h in (8e-3, 4e-3))
    scale = np.maximum(np.abs(numbers(1.0)), 1e-3) / value
    np.testing.assert_allclose(found / scale, (4.0 * fine - coarse) / 3.0 / scale, atol=1e-6)
    assert np.abs(found / scale).max() > 0.01


# The last one lies beyond the curve.
@pytest.mark.parametrize("design", [*DESIGNS, (0.1, 0.32, 0.768, 0.3)])
@pytest.mark.parametrize("mount_height", ["optimal", "fitted"])
def test_against_direct_differences(design, mount_height, curve):
    base = replace(BASE, robot=replace(BASE.robot, mount_height=mount_height))
    found = model_derivatives(base, np.array([design]), curve)[0]
    scale = np.maximum(np.abs(numbers_of(jump_model(variant(base, design)))), 1.0)[:, None]
    assert found.shape == (len(scale), 4)
    np.testing.assert_allclose(
        found / scale, direct_slopes(base, np.array(design)) / scale, atol=1e-6
    )


def test_at_the_ends_of_the_ranges(curve):
    ends = [(0.0, 0.2, 0.768, 0.0), (0.5, 0.31, 0.3, 0.1), (-0.5, 0.09, 0.3, 0.1)]
    assert np.isfinite(model_derivatives(BASE, np.array(ends), curve)).all()


def test_numbers_that_do_not_depend_on_the_design_have_no_derivative(curve):
    found = model_derivatives(BASE, np.array(DESIGNS[:1]), curve)[0]
    model = jump_model(variant(BASE, DESIGNS[0]))
    rod = len(model.discretization)
    frame = rod + len(model.frame)
    assert (found[:rod] == 0.0).all()
    # mu is one number of the friction law; delta_alpha one of the clamps.
    assert np.flatnonzero(found[:, 3]).tolist() == [frame + len(model.clamp) + len(model.contact)]
    assert np.flatnonzero(found[:, 0]).tolist() == [frame + 3]


def test_the_kink_where_the_clamps_change_places(curve):
    """The left clamp starts later by what it lags, but not earlier by what it leads."""
    start = place(jump_model(BASE), "clamp", "start")
    designs = np.array([(lag, *DESIGNS[0][1:]) for lag in (-1e-9, 0.0)])
    lags, leads = model_derivatives(BASE, designs, curve)[:, start, 0]
    assert leads == 0.0
    assert lags == pytest.approx(1.0, rel=1e-9)


def test_thresholds_of_another_beam_are_computed(curve):
    # Thin as the robot of the curve is not: what its thresholds do with the compression is alike.
    inputs = ("design.epsilon", "robot.thickness_m")
    near, far = model_derivatives(BASE, np.array([(0.2, 5e-5), (0.2, 4e-5)]), curve, inputs)
    start = place(jump_model(BASE), "clamp", "start")
    assert near[start, 0] == pytest.approx(far[start, 0], rel=1e-3)


def test_refusals(curve):
    other = replace(BASE, robot=Robot(length_m=0.03))
    with pytest.raises(ParameterError, match="curve = "):
        model_derivatives(other, np.array(DESIGNS[:1]), curve)
