"""Smoothed Coulomb friction; C5 and C6 of references/physics.json."""

import numpy as np
import pytest
from references import outputs_of

from snapjump import Environment, simulate_jump
from snapjump.friction.base import regularised_sign
from snapjump.friction.implicit import ImplicitFriction
from snapjump.friction.lagged import LaggedFriction
from snapjump.friction.none import NoFriction

MU, THRESHOLD = 0.3, 0.02
LAW = ImplicitFriction.Law(MU, THRESHOLD)
speeds = np.linspace(-3.0 * THRESHOLD, 3.0 * THRESHOLD, 301)


def test_once_continuously_differentiable_at_the_threshold():
    for side in (-1.0, 1.0):
        for nearly in (1.0 - 1e-12, 1.0, 1.0 + 1e-12):
            sign, slope = regularised_sign(side * nearly * THRESHOLD, THRESHOLD)
            # C6_paper_friction_bug: without the factor 2 this would be 0
            assert sign == pytest.approx(side, abs=1e-11)
            assert slope * THRESHOLD == pytest.approx(0.0, abs=1e-11)


def test_slope_is_the_derivative():
    step = 1e-7 * THRESHOLD
    for v in speeds[np.abs(np.abs(speeds) - THRESHOLD) >= 1e-6]:
        up, down = (regularised_sign(v + s, THRESHOLD)[0] for s in (step, -step))
        slope = regularised_sign(v, THRESHOLD)[1]
        assert slope * THRESHOLD == pytest.approx((up - down) / (2.0 * step) * THRESHOLD, abs=1e-6)


def test_odd_monotone_and_never_above_one():
    signs = np.array([regularised_sign(v, THRESHOLD)[0] for v in speeds])
    assert (np.diff(signs) >= 0.0).all()
    assert np.abs(signs).max() == 1.0
    assert regularised_sign(0.0, THRESHOLD)[0] == 0.0
    np.testing.assert_allclose(signs, -signs[::-1], atol=1e-15)


@pytest.mark.parametrize("row", [r for r in outputs_of("C5_incline") if "creep_v" in r])
def test_creep_on_a_slope(row):
    """At the velocity over the threshold that holds the robot where gravity pulls so much."""
    assert LAW.ratio(row["w"] * THRESHOLD) == pytest.approx(row["tan"], rel=1e-8)


def test_implicit_law_follows_the_chord_after_a_change_of_sign():
    assert LAW.ratio(5.0 * THRESHOLD) == MU
    assert LAW.slope(5.0 * THRESHOLD, 0.5 * THRESHOLD) == 0.0
    turned = LAW.slope(5.0 * THRESHOLD, -0.5 * THRESHOLD)
    assert turned == pytest.approx(MU / (5.0 * THRESHOLD))
    inside = LAW.slope(0.5 * THRESHOLD, -0.5 * THRESHOLD)
    assert inside == pytest.approx(LAW.ratio(0.5 * THRESHOLD) / (0.5 * THRESHOLD))
    # At the first iterate there is no velocity before.
    assert LAW.slope(0.5 * THRESHOLD, 0.0) == pytest.approx(MU / THRESHOLD)


def test_lagged_law_has_the_same_force_and_no_derivative():
    lagged = LaggedFriction.Law(MU, THRESHOLD)
    for v in speeds:
        assert lagged.ratio(v) == LAW.ratio(v)
        assert lagged.slope(v, -v) == 0.0


def test_what_the_laws_declare():
    laws = [LAW, LaggedFriction.Law(MU, THRESHOLD), NoFriction.Law()]
    assert [law.exists() for law in laws] == [True, True, False]
    assert [law.is_lagged() for law in laws] == [False, True, False]
    assert NoFriction.Law().ratio(1.0) == NoFriction.Law().slope(1.0, 1.0) == 0.0


@pytest.mark.parametrize("mu", [0.3, 5.0])
def test_a_jump_with_the_sharpest_friction_ends_and_does_not_know_its_error(mu):
    jump = simulate_jump(
        accuracy="draft",
        friction=ImplicitFriction(velocity_threshold_m_s=1e-9),
        environment=Environment(mu=mu),
    )
    assert jump.status == "ok" and jump.newton_iterations < 2e4
    assert jump.within_tier is None
