"""Parts of the robot: checked numbers, scales, groups that change nothing, mass and frame."""

import numpy as np
import pytest
from scaled import Factors, scaled

from snapjump import Design, Environment, ParameterError, Robot
from snapjump.checks import check_choice, check_integer, check_number
from snapjump.composition import with_tier
from snapjump.declare.inputs import with_inputs
from snapjump.engine.model import numbers_of
from snapjump.scenes.frame_body import frame_model
from snapjump.scenes.jump_start import composed_model
from snapjump.units import Scales

WRONG_TYPES = [float("nan"), float("inf"), -float("inf"), "1", None, True, [1.0]]


@pytest.mark.parametrize("value", WRONG_TYPES)
def test_numbers_must_be_finite_and_numbers(value):
    with pytest.raises(ParameterError, match="^key = "):
        check_number("key", value)


def test_bounds_are_closed_unless_above():
    check_number("key", 0.0, 0.0, 1.0)
    check_number("key", 1, 0.0, 1.0)
    check_number("key", 1.0, 0.0, 1.0, above=True)
    for value in (-1e-9, 1.0 + 1e-9):
        with pytest.raises(ParameterError, match=r"a number in \[0, 1\] m$"):
            check_number("key", value, 0.0, 1.0, unit="m")
    with pytest.raises(ParameterError, match=r"a number in \(0, 1\]$"):
        check_number("key", 0.0, 0.0, 1.0, above=True)
    with pytest.raises(ParameterError, match=r"a number in \(0, inf\)$"):
        check_number("key", 0.0, 0.0, above=True)


def test_integers_and_choices():
    check_integer("key", 8, 8, 9)
    for value in (7, 10, 8.0, "8", True, None):
        with pytest.raises(ParameterError, match=r"an integer in \[8, 9\]"):
            check_integer("key", value, 8, 9)
    check_choice("key", "a", ("a", "b"))
    for value in ("c", "", None, 1):
        with pytest.raises(ParameterError, match="one of a, b"):
            check_choice("key", value, ("a", "b"))


def test_error_names_key_value_and_range():
    error = ParameterError("design.epsilon", 0.7, "a number in (0, 0.4]")
    assert str(error) == "design.epsilon = 0.7 is not allowed: a number in (0, 0.4]"
    assert (error.key, error.value) == ("design.epsilon", 0.7)
    assert error.allowed == "a number in (0, 0.4]"


def test_scales_are_consistent():
    scales = Scales(0.02, 4e-3, 5e-5)
    assert scales.velocity_m_s == pytest.approx(5.0)
    assert scales.acceleration_m_s2 == pytest.approx(1250.0)
    assert scales.force_N == pytest.approx(5e-5 * 1250.0)
    assert scales.energy_J == pytest.approx(scales.mass_kg * scales.velocity_m_s**2)
    assert scales.stiffness_N_m * scales.length_m == pytest.approx(scales.force_N)


def test_scales_make_the_beam_dimensionless():
    robot = Robot()
    scales = robot.scales
    # D1_frequencies: T of the robot's beam
    assert scales.time_s == pytest.approx(4.38178046e-3, rel=1e-9)
    bending = robot.bending_stiffness_N_m2 / (scales.force_N * scales.length_m**2)
    assert bending == pytest.approx(1.0)
    density = robot.beam_mass_kg / robot.length_m * scales.length_m / scales.mass_kg
    assert density == pytest.approx(1.0)
    area = robot.width_m * robot.thickness_m
    stretching = robot.youngs_modulus_Pa * area / scales.force_N
    assert stretching == pytest.approx(robot.stretching_stiffness_bar)
    assert robot.stretching_stiffness_bar == pytest.approx(12.0 * 400.0**2)


def test_mass_is_defined_by_its_weight():
    # The paper's baseline: mass_bar 0.768 is 4 g.
    assert Environment(mass_bar=0.768).mass_kg(Robot()) == pytest.approx(4e-3)
    robot = Robot()
    light = robot.beam_mass_kg * robot.gravity_m_s2 * robot.length_m**2
    light /= robot.bending_stiffness_N_m2
    with pytest.raises(ParameterError, match=r"environment\.mass_bar = .*mass of the beam"):
        Environment(mass_bar=light).mass_kg(robot)
    assert Environment(mass_bar=1.01 * light).mass_kg(robot) > robot.beam_mass_kg
    with pytest.raises(ParameterError, match=r"robot\.gravity_m_s2"):
        Environment().mass_kg(Robot(gravity_m_s2=0.0))


def dimensionless(simulation):
    """All numbers of a jump's model but its clamps' start, which statics determines."""
    return numbers_of(composed_model(simulation, 0.8, 0.08, simulation.sim.time_limit_s))


def test_scaling_the_robot_at_fixed_groups_changes_no_number():
    base = with_tier("draft")
    other = dimensionless(scaled(base, Factors(length=3.0, time=0.7, mass=50.0)))
    np.testing.assert_allclose(other, dimensionless(base), rtol=1e-12)
    heavier = with_inputs(base, {"robot.density_kg_m3": 2.0 * base.robot.density_kg_m3})
    assert (abs(dimensionless(heavier) - dimensionless(base)) > 1e-3).any()


def test_frame_is_leg_top_leg_with_the_clamped_ends():
    """Centre and inertia against points spread along the three bars."""
    simulation = with_tier("draft", design=Design(0.2, 0.1))
    frame = frame_model(simulation, 0.09)
    robot = simulation.robot
    height, width = robot.frame_height_m / robot.length_m, 0.8
    s = (np.arange(2000) + 0.5) / 2000
    bars = [
        np.stack([np.full_like(s, -0.4), height * s], axis=1),
        np.stack([width * (s - 0.5), np.full_like(s, height)], axis=1),
        np.stack([np.full_like(s, 0.4), height * s], axis=1),
    ]
    mass = simulation.environment.mass_kg(robot) / robot.beam_mass_kg - 1.0
    lengths = np.array([height, width, height])
    weights = [np.full(2000, mass * n / lengths.sum() / 2000) for n in lengths]
    ends = np.array([[-0.4, 0.09], [0.4, 0.09]])
    points = np.concatenate([*bars, ends])
    end = 0.5 / simulation.discretization.elements
    weight = np.concatenate([*weights, [end, end]])
    centre = weight @ points / weight.sum()
    inertia = weight @ ((points - centre) ** 2).sum(axis=1)
    assert frame.mass == pytest.approx(weight.sum(), rel=1e-12)
    assert centre[0] == pytest.approx(0.0, abs=1e-12)
    assert frame.foot_y == pytest.approx(-centre[1], rel=1e-10)
    assert frame.mount_y == pytest.approx(0.09 - centre[1], rel=1e-10)
    assert frame.top_y == pytest.approx(height - centre[1], rel=1e-10)
    assert frame.inertia == pytest.approx(inertia, rel=1e-6)
    assert frame.half_span == 0.4
