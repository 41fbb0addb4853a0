"""Arches: exact ones, slender ones on fine meshes, their lowest points, angles and thresholds."""

import numpy as np
import pytest
from differences import slope
from scipy.optimize import brentq
from scipy.special import ellipe, ellipj, ellipk

from experiments.slender import WAYS, slender_arches
from snapjump import ParameterError, Robot
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.statics.arch import StaticArch
from snapjump.statics.chain_state import chord_angles
from snapjump.statics.critical import find_snap
from snapjump.statics.elastica import buckled_arch
from snapjump.statics.lowest_point import lowest_height
from snapjump.statics.rounding import LARGEST_ANGLE_ERROR_RAD, LostToRoundingError
from snapjump.statics.threshold import symmetric_threshold
from snapjump.statics.threshold_curve import ThresholdCurve, direct


@pytest.mark.parametrize("arch", slender_arches(12), ids=lambda arch: f"{arch[1]}")
def test_both_ways_to_the_angle_agree_within_what_they_state(arch):
    found = [way(*arch) for way in WAYS.values()]
    apart = abs(found[0].alpha_rad - found[1].alpha_rad)
    assert apart <= sum(one.alpha_error_rad for one in found)
    assert max(one.alpha_error_rad for one in found) <= LARGEST_ANGLE_ERROR_RAD


@pytest.mark.parametrize("clamp", ["two_nodes", "half_element"])
def test_a_state_that_rounding_shakes_is_an_equilibrium(clamp):
    """Corrections of 1e-10 L, the test for other beams, are about what rounding leaves here."""
    arch = StaticArch(Robot(thickness_m=2e-6), DiscreteElasticRod(160, clamp), 0.1)
    for seed in range(6):
        noise = np.random.default_rng(seed).uniform(-1e-15, 1e-15, arch.size)
        state = arch.solve_equilibrium(arch.guess() * (1.0 + noise), 0.0, 0.0)
        state = arch.turn(state, (0.0, 0.0), (0.4, 0.4))
        assert np.abs(arch.residual(state, 0.4, 0.4)).max() <= arch.rounding
        assert arch.accuracy < 1e-8


def test_a_state_that_is_none_is_none():
    """Rounding is no excuse for an arch that has no equilibrium nearby."""
    arch = StaticArch(Robot(thickness_m=2e-6), DiscreteElasticRod(160), 0.1)
    with pytest.raises(ArithmeticError, match="no equilibrium found at clamp angles 1.5, 1.5 rad"):
        arch.solve_equilibrium(arch.guess(), 1.5, 1.5)


def test_an_angle_that_rounding_spoils_is_refused_by_name():
    with pytest.raises(LostToRoundingError, match="elements = 640 is not allowed: a coarser mesh"):
        symmetric_threshold(Robot(thickness_m=4e-7), DiscreteElasticRod(640), 0.2)


@pytest.mark.parametrize("epsilon", [1e-4, 0.01, 0.2, 0.4])
def test_arch(epsilon):
    elements = 60
    m = brentq(lambda m: 2.0 - 2.0 * ellipe(m) / ellipk(m) - epsilon, 1e-12, 0.9, xtol=1e-16)
    s = (np.arange(elements) + 0.5) / elements
    tangent = 2.0 * np.arcsin(np.sqrt(m) * ellipj(4.0 * ellipk(m) * s, m)[0])
    x, y = buckled_arch(epsilon, elements)
    stretch = (1.0 - epsilon) / (np.cos(tangent).sum() / elements)
    assert np.allclose(np.diff(x), stretch * np.cos(tangent) / elements, rtol=0.0, atol=1e-13)
    assert np.allclose(np.diff(y), np.sin(tangent) / elements, rtol=0.0, atol=1e-13)
    assert x[0] == pytest.approx(-x[-1], abs=1e-15) and abs(y[-1]) < 1e-14


def test_many_arches_are_each_its_own():
    together = buckled_arch(np.array([0.1, 0.2]), 20)
    for k, epsilon in enumerate((0.1, 0.2)):
        for both, alone in zip(together, buckled_arch(epsilon, 20), strict=True):
            assert np.array_equal(both[k], alone)


@pytest.mark.parametrize("angle", np.linspace(-3.0, 3.0, 13))
def test_directions_of_chords(angle):
    x, y = np.array([0.0, 9.0, np.cos(angle)]), np.array([0.0, 9.0, np.sin(angle)])
    assert chord_angles(x, y)[0] == pytest.approx(angle, abs=1e-14)


def test_a_quintic_is_its_own_spline():
    places = np.arange(9.0)
    heights = (places - 3.3) ** 2 * (1.0 + 0.02 * (places - 3.3) ** 3) - 0.7
    assert lowest_height(heights) == pytest.approx(-0.7, abs=1e-12)


def test_the_lowest_node_may_be_an_end():
    assert lowest_height(np.arange(8.0)) == 0.0
    assert lowest_height(-np.arange(8.0)) == -7.0


def test_it_is_smooth_as_the_lowest_point_passes_a_node():
    """A wave that is shifted past nodes keeps its depth."""
    places = np.arange(105.0)
    shifts = np.linspace(-2.0, 2.0, 201)
    found = [lowest_height(-0.08 * np.sin(6.0 * (places - shift) / 104.0)) for shift in shifts]
    assert np.ptp(found) < 1e-11
    assert found[100] == pytest.approx(-0.08, abs=1e-11)


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
    """Thresholds over a range of compressions, of a mesh."""
    return ThresholdCurve.through(Robot(), request.param, 0.09, 0.31)


def test_interpolated_thresholds_are_those_that_are_computed(curve):
    compressions = np.random.default_rng(3).uniform(0.09, 0.31, 40)
    errors = np.abs(
        curve.values(compressions) - direct(curve.robot, curve.discretization, compressions)
    )
    assert errors.max() < 1e-8
    # The curve's own account of its errors is of the right size.
    assert 0.1 < errors[0].max() / curve.angle_error < 10.0
    assert 0.1 < errors[1].max() / curve.depth_error < 10.0


def test_slopes_of_thresholds(curve):
    compressions = np.array([0.11, 0.2, 0.28])
    robot, mesh = curve.robot, curve.discretization
    expected = slope(lambda change: direct(robot, mesh, compressions + change), 1.2e-2)
    assert np.abs(curve.slopes(compressions) - expected).max() < 1e-6


def test_the_range_of_a_curve(curve):
    assert curve.covers([0.08, 0.09, 0.2, 0.31, 0.32]).tolist() == [False, True, True, True, False]


@pytest.mark.parametrize("ends", [(0.0, 0.3), (0.3, 0.3), (0.3, 0.2), (0.1, 0.41)])
def test_ranges_that_no_curve_has(ends):
    with pytest.raises(ParameterError, match="0 < low < high <= 0.4"):
        ThresholdCurve.through(Robot(), MESHES[0], *ends)


def test_a_range_with_arches_that_do_not_snap():
    """A beam of a tenth of its length is compressed straight before it buckles."""
    thick = Robot(thickness_m=0.002)
    with pytest.raises(ParameterError, match="all buckle"):
        ThresholdCurve.through(thick, MESHES[0], 0.01, 0.3)
