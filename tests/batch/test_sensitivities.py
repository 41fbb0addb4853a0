"""Sensitivities of batches: independent of lanes and threads, right, and refused where unknown."""

from dataclasses import replace

import numpy as np
import pytest
from robots import BASELINE as FINE

from snapjump.batch import simulate_designs
from snapjump.batch.sensitivities import NEAREST, Slopes, apex_sensitivities
from snapjump.checks import ParameterError
from snapjump.drag.none import NoDrag
from snapjump.drag.quadratic import QuadraticDrag
from snapjump.engine import outcome as c
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.status import OK
from snapjump.friction.implicit import ImplicitFriction
from snapjump.scenes.flight import flight
from snapjump.statics.threshold_curve import ThresholdCurve

pytestmark = pytest.mark.compiles

BASE = replace(FINE, friction=ImplicitFriction(velocity_threshold_m_s=0.01))
# delta_alpha, epsilon, mass_bar, mu; the last one cannot be built.
DESIGNS = np.array([
    [0.02, 0.12, 0.4, 0.1], [0.10, 0.20, 0.768, 0.3], [0.15, 0.28, 1.5, 0.6],
    [0.05, 0.20, 2.0, 0.2], [0.00, 0.25, 0.9, 0.3], [0.10, 0.20, 0.768, 0.0],
    [0.10, 0.20, 1e-6, 0.3],
])  # fmt: skip


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.1, 0.3)


@pytest.fixture(scope="module")
def batch(curve):
    """Jumps of the designs, with their derivatives."""
    return simulate_designs(BASE, DESIGNS, curve=curve, threads=1, lanes=8, sensitivities=True)


def test_jumps_are_the_same_without(batch, curve):
    plain = simulate_designs(BASE, DESIGNS, curve=curve, threads=1, lanes=8)
    assert plain.sensitivities is None
    assert batch.status == plain.status
    np.testing.assert_array_equal(batch.x_bar, plain.x_bar)
    np.testing.assert_array_equal(batch.newton_iterations, plain.newton_iterations)


def test_they_do_not_depend_on_lanes_and_threads(batch, curve):
    other = simulate_designs(BASE, DESIGNS, curve=curve, threads=2, lanes=1, sensitivities=True)
    for name in ("dx_bar", "dy_bar", "graze_distance", "differentiable"):
        found, expected = getattr(other.sensitivities, name), getattr(batch.sensitivities, name)
        np.testing.assert_array_equal(found, expected)


def test_what_has_no_apex_has_none(batch, curve):
    assert batch.status == ["ok"] * 6 + ["bad_design"]
    found = batch.sensitivities
    assert found.dx_bar.shape == found.dy_bar.shape == (7, 4)
    assert np.isfinite(found.dx_bar[:6]).all() and np.isfinite(found.dy_bar[:6]).all()
    assert np.isnan(found.dx_bar[6]).all() and np.isnan(found.graze_distance[6])
    assert not found.differentiable[6]
    np.testing.assert_array_equal(found.differentiable[:6], found.graze_distance[:6] > NEAREST)
    nothing = simulate_designs(BASE, DESIGNS[6:], curve=curve, sensitivities=True)
    assert nothing.status == ["bad_design"] and np.isnan(nothing.sensitivities.dx_bar).all()


def test_what_physics_asks_of_them(batch):
    """More compression is more energy; at delta_alpha = 0 nothing but delta_alpha moves x."""
    assert (batch.sensitivities.dy_bar[:6, 1] > 0.0).all()
    even = batch.sensitivities.dx_bar[4]
    assert abs(even[0]) > 1.0
    assert np.abs(even[1:]).max() < 1e-6 * abs(even[0])


@pytest.mark.parametrize("share", [None, 0.01])
def test_gravity_and_drag_move_the_flight_too(share):
    """An apex is read off as flights are, with made-up slopes of all that it depends on."""
    slopes = np.array([0.3, -0.2, 1.5, 0.7, 0.9, 0.02])  # of x, y, vx, vy, gravity and drag

    def at(way):
        outcome = np.zeros((1, c.COLUMNS))
        outcome[0, c.STATUS] = OK
        values = np.array([0.1, 0.6, 2.0, 5.0, 3.0, share or 0.0]) + way * slopes
        outcome[0, [c.COM_X, c.COM_Y, c.COM_VX, c.COM_VY]] = values[:4]
        gravity = Gravity(*(np.array([value]) for value in (values[4], 0.8, 0.6, 0.0)))
        return gravity, outcome, QuadraticDrag.Law(values[5:]) if share else NoDrag.Law()

    fall, outcome, air = at(0.0)
    ahead, behind = (flight(0.0, *at(way)) for way in (1e-6, -1e-6))
    load = np.array([slopes[4], 0.0, 0.0, 0.0])[None, :, None]
    given = Slopes(slopes[None, :4, None], load, slopes[None, 6 - len(air) :, None], np.ones(1))
    found = apex_sensitivities(outcome, fall, air, given, np.inf)
    close = 1e-6 if share else 1e-8
    assert found.dx_bar[0, 0] == pytest.approx((ahead.apex_x - behind.apex_x)[0] / 2e-6, rel=close)
    assert found.dy_bar[0, 0] == pytest.approx((ahead.apex_y - behind.apex_y)[0] / 2e-6, rel=close)


def test_inputs_that_are_none_of_the_four():
    """They are the same for a robot alone and beside others, without a curve."""
    inputs = ("robot.gravity_m_s2", "drive.rate_rad_s")
    found = simulate_designs(BASE, np.array([[10.0, 20.0]]), inputs=inputs, sensitivities=True)
    assert found.status == ["ok"] and found.sensitivities.dy_bar.shape == (1, 2)
    alone = simulate_designs(BASE, np.array([[20.0]]), inputs=inputs[1:], sensitivities=True)
    assert alone.sensitivities.dx_bar[0, 0] == found.sensitivities.dx_bar[0, 1]


def test_slopes_through_a_stick_zone_that_steps_jump_over_are_not_known(batch, curve):
    """Those of the steps are told all the same, at the tiers' own zone. Of a batch in which the
    zone varies every jump is judged by its own."""
    told = simulate_designs(FINE, DESIGNS, curve=curve, threads=1, lanes=8, sensitivities=True)
    assert np.isfinite(told.sensitivities.dx_bar[:6]).all()
    assert not told.sensitivities.differentiable.any()
    assert batch.sensitivities.differentiable[:4].all()
    zones, inputs = np.array([[0.001], [0.01]]), ("friction.velocity_threshold_m_s",)
    varied = simulate_designs(FINE, zones, inputs=inputs, sensitivities=True)
    assert varied.status == ["ok"] * 2
    assert varied.sensitivities.differentiable.tolist() == [False, True]


UNKNOWN = {
    "frame": replace(BASE, frame="elastic"),
    "contact": replace(BASE, contact="signorini", integrator="implicit_euler"),
    "backend": replace(BASE, backend="cuda"),
}


@pytest.mark.parametrize("named", UNKNOWN)
def test_modules_that_they_do_not_know(named, curve):
    with pytest.raises(ParameterError, match=named):
        simulate_designs(UNKNOWN[named], DESIGNS[:1], curve=curve, sensitivities=True)
