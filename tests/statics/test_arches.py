"""Arches: exact ones, slender ones on fine meshes, and their lowest points."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipj, ellipk

from experiments.slender import WAYS, slender_arches
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.robot.robot import Robot
from snapjump.statics.arch import StaticArch
from snapjump.statics.chain_state import chord_angles
from snapjump.statics.elastica import buckled_arch
from snapjump.statics.lowest_point import lowest_height
from snapjump.statics.rounding import LARGEST_ANGLE_ERROR_RAD, LostToRoundingError
from snapjump.statics.threshold import symmetric_threshold


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
