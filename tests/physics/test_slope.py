"""Jumps from a slope, how they begin, fly and balance their books; C4, C5: one mass that slides."""

import math

import numpy as np
import pytest
from physical import jump, run, single_mass
from references import outputs_of as reference

from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.friction.implicit import ImplicitFriction
from snapjump.friction.lagged import LaggedFriction
from snapjump.robot.environment import Environment
from snapjump.sim.jump import Jump

SLOPES = (-0.2, 0.1, 0.28)
G = 10.0
LENGTH_M = 0.02


def creep_m_s(simulation):
    """The speed at which smoothed Coulomb friction, 2 w - w^2, is the slope's tangent over mu."""
    environment, threshold = simulation.environment, simulation.friction.velocity_threshold_m_s
    share = math.tan(abs(environment.slope_rad)) / environment.mu
    size = threshold * (1.0 - math.sqrt(1.0 - share))
    return -math.copysign(size, environment.slope_rad)


@pytest.mark.parametrize("slope", SLOPES)
def test_a_robot_begins_to_creep_as_friction_holds_it(slope):
    friction = ImplicitFriction(1e-4)
    scene = Jump(sample_interval_s=5e-6)
    sloping = jump(environment=Environment(slope_rad=slope), friction=friction, sim=scene)
    arrays, creep = sloping.arrays, creep_m_s(sloping.simulation)
    # What pulls it downhill is what friction takes, until the beam begins to swing.
    feet, time = arrays["corner_x_m"][:2, :2], arrays["time_s"][:2]
    speeds = (feet[1] - feet[0]) / (time[1] - time[0])
    np.testing.assert_allclose(speeds, creep, atol=2e-6)
    normal, drag = (arrays[f"corner_{force}_N"][0].sum() for force in ("normal", "friction"))
    assert drag / normal == pytest.approx(math.tan(slope), rel=1e-2)


@pytest.mark.parametrize("slope", SLOPES)
def test_the_flight_is_the_parabola_of_gravity(slope):
    """In level and plumb places: there is no force but the weight after the last contact."""
    found = jump(environment=Environment(slope_rad=slope))
    c, s = math.cos(slope), math.sin(slope)
    vx, vy = found.liftoff_vx_m_s, found.liftoff_vy_m_s
    along, across = found.liftoff_x_bar * LENGTH_M, found.liftoff_y_bar * LENGTH_M
    rise, level = vx * s + vy * c, vx * c - vy * s
    ahead = rise / G
    assert found.apex_time_s - found.liftoff_time_s == pytest.approx(ahead, rel=1e-6)
    plumb = across * c + along * s + 0.5 * rise * ahead
    assert found.y_world_bar * LENGTH_M == pytest.approx(plumb, rel=1e-6)
    distance = along * c - across * s + level * ahead
    assert found.x_world_bar * LENGTH_M == pytest.approx(distance, rel=1e-5, abs=1e-6)
    turned = (found.x_bar * s + found.y_bar * c, found.x_bar * c - found.y_bar * s)
    assert turned == pytest.approx((found.y_world_bar, found.x_world_bar), rel=1e-12, abs=1e-12)


def test_on_the_level_both_places_are_one():
    found = jump()
    assert (found.x_world_bar, found.y_world_bar) == (found.x_bar, found.y_bar)


@pytest.mark.parametrize("slope", SLOPES)
def test_books_balance(slope):
    arrays = jump(environment=Environment(slope_rad=slope)).arrays
    released = np.ptp(arrays["elastic_J"])
    assert np.abs(arrays["numerical_loss_J"]).max() < 1e-2 * released


@pytest.mark.parametrize("slope", [0.3, -0.3, math.atan(0.3)])
def test_what_slides_is_refused(slope):
    with pytest.raises(ParameterError, match=r"environment\.slope_rad = .* holds the robot"):
        with_tier("draft", environment=Environment(slope_rad=slope))
    with_tier("draft", environment=Environment(mu=0.5, slope_rad=slope), friction=LaggedFriction())


def test_without_friction_the_ground_is_level():
    with pytest.raises(ParameterError, match=r"environment\.slope_rad = 0.1 .* 0 without friction"):
        with_tier("draft", environment=Environment(slope_rad=0.1), friction="none")
    with_tier("draft", friction="none")


def test_slide_to_rest():
    exact = reference("C4_slide")
    result = run(single_mass("slide", 1e-5, mu=exact["mu"], speed_m_s=exact["v0"]))
    assert result.distance_m == pytest.approx(exact["x_total"], rel=1e-4)
    speed = result.arrays["node_vx_m_s"][:, 0]
    time = result.arrays["time_s"]
    reached = np.interp(-exact["eps_v"], -speed, time)
    assert reached == pytest.approx(exact["t_to_eps"], rel=1e-4)
    assert 0.0 <= result.final_speed_m_s < 1e-9


def on_an_incline(row, speed_m_s):
    scene = {"speed_m_s": speed_m_s, "duration_s": 0.01}
    slope_rad = -np.arctan(row["tan"])
    return run(single_mass("slide", 1e-5, mu=row["mu"], slope_rad=slope_rad, **scene))


@pytest.mark.parametrize("slope", [0.05, 0.15, 0.29])
def test_creep_on_an_incline(slope):
    row = next(r for r in reference("C5_incline") if r["tan"] == slope)
    result = on_an_incline(row, 0.0)
    assert result.final_speed_m_s == pytest.approx(row["creep_v"], rel=1e-6)


def test_slip_on_an_incline():
    row, start = next(r for r in reference("C5_incline") if "accel_over_gcos" in r), 0.1
    result = on_an_incline(row, start)
    acceleration = (result.final_speed_m_s - start) / result.arrays["time_s"][-1]
    normal = 10.0 * np.cos(np.arctan(row["tan"]))
    assert acceleration / normal == pytest.approx(row["accel_over_gcos"], rel=1e-6)
