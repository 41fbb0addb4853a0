"""Strain of the beam and torques of the clamps: against circles, statics, and the work done."""

import numpy as np
import pytest
from physical import DESIGNS, discretized, parts_of, slender, snap

from snapjump import simulate_jump
from snapjump.discretization.base import EndTangents
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.bending import fill_turnings
from snapjump.robot.robot import Robot


def turnings(beam, nodes, position, left, right):
    """Turnings (N + 1) of a chain between clamps in these directions (rad)."""
    found = np.zeros(nodes)
    ends = np.cos(left), np.sin(left), 0.0, np.cos(right), np.sin(right), 0.0, 0.0, 0.0
    fill_turnings(beam, position, EndTangents(*ends), found)
    return found


def test_a_circle_turns_by_as_much_at_every_node():
    radius, angles = 0.3, np.linspace(0.1, 1.5, 33)
    places = radius * np.stack([np.sin(angles), -np.cos(angles)], axis=1)
    turn = angles[1] - angles[0]
    for clamp, at_ends in (("half_element", 2.0), ("two_nodes", 1.0)):
        beam = DiscreteElasticRod(elements=32, clamp=clamp).beam(Robot())
        found = turnings(beam, len(angles), places.ravel(), *angles[[0, -1]])
        np.testing.assert_allclose(found[1:-1], 2.0 * np.tan(0.5 * turn), rtol=1e-12)
        ends = at_ends * 2.0 * np.tan(0.25 * turn)
        np.testing.assert_allclose(found[[0, -1]], ends, rtol=1e-12)


@pytest.mark.parametrize("rod", ["corotational", "geometrically_exact"])
def test_nodes_that_turn_tell_a_curvature_that_grows_linearly(rod):
    """Of rotations that are quadratic in the node's number, also at the ends."""
    beam, node = discretized(rod, 20).beam(slender(1e-4)), np.arange(21)
    position = np.zeros(3 * len(node))
    position[2::3] = beam.rotation_length() * (0.02 * node + 0.003 * node**2)
    found = turnings(beam, len(node), position, 0.0, 0.0)
    np.testing.assert_allclose(found, 0.02 + 0.006 * node, atol=1e-14)


@pytest.fixture(scope="module")
def jump():
    return simulate_jump(
        accuracy="draft", sim={"sample_interval_s": 1e-5}, **parts_of(DESIGNS["baseline"])
    )


def test_power_adds_up_to_the_clamps_work(jump):
    kept = jump.arrays
    power = sum(
        kept[f"clamp_{side}_torque_N_m"] * np.gradient(kept[f"clamp_{side}_rad"], kept["time_s"])
        for side in ("left", "right")
    )
    work = np.trapezoid(power, kept["time_s"])
    assert work == pytest.approx(jump.summary["clamp_work_J"], rel=5e-3)
    assert jump.summary["peak_clamp_power_W"] == pytest.approx(power.max())


@pytest.mark.parametrize("rod", ["der", "corotational", "geometrically_exact"])
def test_at_its_threshold_an_arch_bends_as_the_elastica(rod):
    """kappa (1 - epsilon) = 2 sin(alpha) at the clamps of a symmetric arch about to snap."""
    errors = []
    for elements in (48, 96):
        at = snap(0.2, elements, name=rod).before
        beam = discretized(rod, elements).beam(slender(1e-4))
        found = elements * turnings(beam, elements + 1, at.state, -at.left, at.right)[[0, -1]]
        errors.append(np.abs(found * 0.8 / (2.0 * np.sin(at.left)) - 1.0).max())
    assert errors[1] < 0.3 * errors[0] < 0.02


def test_a_builder_s_figures_go_together(jump):
    told, robot = jump.summary, jump.simulation.robot
    assert 0.010 < told["max_strain"] < 0.014  # the elastica's largest, at epsilon 0.2: 1.2 %
    assert told["max_stress_Pa"] == pytest.approx(robot.youngs_modulus_Pa * told["max_strain"])
    assert np.isnan(told["safety_factor"])
    sample = int(np.abs(jump.arrays["time_s"] - told["max_strain_time_s"]).argmin())
    node = round(told["max_strain_at_bar"] * (jump.arrays["node_strain"].shape[1] - 1))
    # Its largest is between two samples.
    nearest = abs(jump.arrays["node_strain"][sample, node])
    assert 0.99 * told["max_strain"] < nearest <= told["max_strain"]


def test_a_yield_stress_gives_a_safety_factor_and_moves_nothing(jump):
    parts = parts_of(DESIGNS["baseline"])
    steel = simulate_jump(
        accuracy="draft", sim={"sample_interval_s": 1e-5}, **parts, robot={"yield_stress_Pa": 1.5e9}
    )
    assert (steel.x_bar, steel.y_bar) == (jump.x_bar, jump.y_bar)
    assert steel.summary["safety_factor"] == pytest.approx(1.5e9 / steel.summary["max_stress_Pa"])


def test_impulse_is_the_momentum_gained_and_the_weight_borne(jump):
    kept, told = jump.arrays, jump.summary
    robot = jump.simulation.robot
    mass_kg = jump.simulation.environment.mass_kg(robot)
    flown = kept["time_s"][-1] - kept["time_s"][0]
    gained = mass_kg * (kept["com_vy_m_s"][-1] - kept["com_vy_m_s"][0])
    expected = gained + mass_kg * robot.gravity_m_s2 * flown
    assert told["ground_impulse_N_s"] == pytest.approx(expected, rel=1e-6)
    force = kept["node_normal_N"].sum(axis=1) + kept["corner_normal_N"].sum(axis=1)
    assert told["peak_ground_force_N"] >= force.max() > mass_kg * robot.gravity_m_s2


def test_lift_off_tells_spin_direction_and_landing(jump):
    kept, told = jump.arrays, jump.summary
    aloft = kept["time_s"] > told["liftoff_time_s"]
    turning = np.polyfit(kept["time_s"][aloft], kept["frame_angle_rad"][aloft], 1)[0]
    assert told["spin_rad_s"] == pytest.approx(turning, rel=0.01)
    vx, vy = told["liftoff_vx_m_s"], told["liftoff_vy_m_s"]
    assert np.tan(told["takeoff_angle_rad"]) == pytest.approx(vy / vx)
    robot = jump.simulation.robot
    far = 2.0 * vx * vy / robot.gravity_m_s2 / robot.length_m
    assert told["landing_x_bar"] == pytest.approx(told["liftoff_x_bar"] + far)


def test_efficiency_is_height_over_what_was_given(jump):
    kept, told = jump.arrays, jump.summary
    robot = jump.simulation.robot
    rise_m = told["y_bar"] * robot.length_m - kept["com_y_m"][0]
    height_J = jump.simulation.environment.mass_kg(robot) * robot.gravity_m_s2 * rise_m
    assert 0.3 < told["efficiency"] < 1.0
    given = height_J / told["efficiency"]
    assert given == pytest.approx(told["clamp_work_J"] + kept["elastic_J"][0], rel=0.5)
