"""The jump's symmetries: mirror, momentum, similarity."""

import dataclasses

import numpy as np
import pytest

from snapjump import Design, Environment, Robot
from snapjump.declare.members import member_class


def test_equal_clamps_jump_straight_up(jump):
    result = jump(design=Design(0.2, 0.0))
    assert abs(result.x_bar) <= 1e-8
    assert np.abs(result.arrays["frame_angle_rad"]).max() < 1e-8


@pytest.mark.parametrize("slope", [0.0, 0.15])
def test_mirrored_mismatch_and_slope_mirror_the_jump(slope, jump):
    """The left clamp is the reference: the mirror image starts and ends that much earlier.

    The elimination runs from left to right, so that the two differ by rounding, and adaptive
    steps raise that to a share of their tolerance.
    """
    lag = 0.1
    robot = Robot()
    tight = member_class("stepping", "adaptive")(tolerance=1e-8, contact_steps=0.5)
    uphill, downhill = (Environment(slope_rad=sign * slope) for sign in (1.0, -1.0))
    right = jump(design=Design(0.2, lag), environment=uphill, stepping=tight)
    left = jump(
        design=Design(0.2, -lag),
        environment=downhill,
        robot=dataclasses.replace(robot, rotation_end_rad=robot.rotation_end_rad - lag),
        stepping=tight,
    )
    assert left.x_bar == pytest.approx(-right.x_bar, rel=1e-3)
    assert left.y_bar == pytest.approx(right.y_bar, rel=1e-4)
    assert left.x_world_bar == pytest.approx(-right.x_world_bar, rel=1e-3)


def test_without_friction_nothing_moves_sideways(jump):
    result = jump(environment=Environment(mu=0.0))
    assert np.abs(result.arrays["com_vx_m_s"]).max() < 1e-10 * result.liftoff_vy_m_s


def test_similarity(jump):
    """E, rho and L scaled at fixed dimensionless groups change nothing.

    By powers of two, so that rounding is the same: else adaptive steps raise it to 1e-3 here.
    """
    baseline = jump()
    stiffer, denser, larger = 0.25, 4.0, 2.0
    time = larger * np.sqrt(denser / stiffer)
    robot = Robot()
    base = baseline.simulation
    scaled = jump(
        robot=dataclasses.replace(
            robot,
            length_m=robot.length_m * larger,
            width_m=robot.width_m * larger,
            thickness_m=robot.thickness_m * larger,
            frame_height_m=robot.frame_height_m * larger,
            youngs_modulus_Pa=robot.youngs_modulus_Pa * stiffer,
            density_kg_m3=robot.density_kg_m3 * denser,
            gravity_m_s2=float(robot.gravity_m_s2 * larger / time**2),
            rotation_rate_rad_s=float(robot.rotation_rate_rad_s / time),
        ),
        contact=dataclasses.replace(
            base.contact,
            stiffness_N_m=base.contact.stiffness_N_m * stiffer * larger,
            distance_m=base.contact.distance_m * larger,
        ),
        friction=dataclasses.replace(
            base.friction,
            velocity_threshold_m_s=float(base.friction.velocity_threshold_m_s * larger / time),
        ),
        damping=dataclasses.replace(
            base.damping, relaxation_time_s=float(base.damping.relaxation_time_s * time)
        ),
        sim=dataclasses.replace(
            base.sim,
            time_limit_s=float(base.sim.time_limit_s * time),
            sample_interval_s=float(base.sim.sample_interval_s * time),
        ),
    )
    assert scaled.x_bar == pytest.approx(baseline.x_bar, rel=1e-6)
    assert scaled.y_bar == pytest.approx(baseline.y_bar, rel=1e-6)
    assert scaled.apex_time_s == pytest.approx(baseline.apex_time_s * time, rel=1e-6)
