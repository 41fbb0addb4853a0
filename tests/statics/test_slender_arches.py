"""Slender arches on fine meshes, where rounding is large: every angle is what it states."""

import numpy as np
import pytest

from experiments.slender import WAYS, slender_arches
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.robot.robot import Robot
from snapjump.statics.arch import StaticArch
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
