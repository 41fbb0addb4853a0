"""The quick critical angle against the walk along the branch, and interpolated thresholds."""

import numpy as np
import pytest
from differences import slope

from snapjump import ParameterError, Robot
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.statics.critical import find_snap
from snapjump.statics.threshold import symmetric_threshold
from snapjump.statics.threshold_curve import ThresholdCurve, direct


@pytest.mark.parametrize("epsilon", [0.01, 0.1, 0.25, 0.4])
@pytest.mark.parametrize(("elements", "clamp"), [(112, "half_element"), (66, "two_nodes")])
def test_both_ways_to_the_critical_angle_agree(elements, clamp, epsilon):
    discretization = DiscreteElasticRod(elements=elements, clamp=clamp)
    quick = symmetric_threshold(Robot(), discretization, epsilon)
    walked = find_snap(Robot(), discretization, epsilon, 0.0)
    assert quick.alpha_rad == pytest.approx(walked.alpha_rad, abs=1e-8)
    assert quick.h1_bar == pytest.approx(walked.h1_bar, abs=1e-8)


def test_second_order_in_the_element_length():
    coarse, middle, fine = (
        symmetric_threshold(Robot(), DiscreteElasticRod(elements=n), 0.2).alpha_rad
        for n in (56, 112, 224)
    )
    assert (middle - coarse) / (fine - middle) == pytest.approx(4.0, rel=0.02)
    # S7, EI/(EA L^2) = 5.2e-7: extensible pitchfork at epsilon 0.2.
    assert fine + (fine - middle) / 3.0 == pytest.approx(0.9115924168, abs=1e-6)


MESHES = (
    DiscreteElasticRod(elements=104),
    DiscreteElasticRod(elements=66, clamp="two_nodes"),
    Corotational(elements=64),
)


@pytest.fixture(scope="module", params=MESHES, ids=lambda mesh: type(mesh).__name__)
def curve(request):
    return ThresholdCurve.through(Robot(), request.param, 0.09, 0.31)


def test_values(curve):
    compressions = np.random.default_rng(3).uniform(0.09, 0.31, 40)
    errors = np.abs(
        curve.values(compressions) - direct(curve.robot, curve.discretization, compressions)
    )
    assert errors.max() < 1e-8
    # The curve's own account of its errors is of the right size.
    assert 0.1 < errors[0].max() / curve.angle_error < 10.0
    assert 0.1 < errors[1].max() / curve.depth_error < 10.0


def test_slopes(curve):
    compressions = np.array([0.11, 0.2, 0.28])
    robot, mesh = curve.robot, curve.discretization
    expected = slope(lambda change: direct(robot, mesh, compressions + change), 1.2e-2)
    assert np.abs(curve.slopes(compressions) - expected).max() < 1e-6


def test_range(curve):
    assert curve.covers([0.08, 0.09, 0.2, 0.31, 0.32]).tolist() == [False, True, True, True, False]


@pytest.mark.parametrize("ends", [(0.0, 0.3), (0.3, 0.3), (0.3, 0.2), (0.1, 0.41)])
def test_no_such_range(ends):
    with pytest.raises(ParameterError, match="0 < low < high <= 0.4"):
        ThresholdCurve.through(Robot(), MESHES[0], *ends)


def test_a_range_with_arches_that_do_not_snap():
    """A beam of a tenth of its length is compressed straight before it buckles."""
    thick = Robot(thickness_m=0.002)
    with pytest.raises(ParameterError, match="all buckle"):
        ThresholdCurve.through(thick, MESHES[0], 0.01, 0.3)
