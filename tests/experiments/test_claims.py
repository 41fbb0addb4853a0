"""Robots that differ in more than numbers are judged, each in a batch of its kind."""

import pytest

from experiments.claims.judge import found
from snapjump.composition import with_tier
from snapjump.drive.constant_rate import ConstantRate

AS_LEFT = {"design.delta_alpha": 0.1}
OWN_RATE = {"drive.right_rate_rad_s": ConstantRate().rate_rad_s}
REFUSED = {"design.epsilon": 0.2, "environment.mass_bar": 1e-3}


@pytest.mark.compiles
def test_clamps_of_one_rate_and_of_two_are_judged_beside_each_other():
    of = found(with_tier("draft"), [AS_LEFT, OWN_RATE, REFUSED, AS_LEFT], 2e4, 1)
    assert of.status == ["ok", "ok", "refused", "ok"]
    assert of.within[:2] == [True, True] and of.within[2] is None
    assert of.y[0] == of.y[3] == pytest.approx(of.y[1], rel=1e-6)
    assert (of.iterations[[0, 1, 3]] > 100).all()
