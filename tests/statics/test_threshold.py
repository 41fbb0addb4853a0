"""The quick critical angle against the walk along the branch."""

import pytest

from snapjump.discretization.der import DiscreteElasticRod
from snapjump.parameters.robot import Robot
from snapjump.statics.critical import find_snap
from snapjump.statics.threshold import symmetric_threshold


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
