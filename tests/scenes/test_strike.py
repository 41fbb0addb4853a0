"""What is read off a followed jump, from trajectories that are made up."""

from typing import Any

import numpy as np
import pytest

from snapjump.composition import with_tier
from snapjump.results import Result
from snapjump.scenes import strike

BASE = with_tier("draft")
LENGTH_M, MU = BASE.robot.length_m, BASE.environment.mu
MASS_KG = BASE.environment.mass_kg(BASE.robot)
TIMES = np.arange(5) * 1e-3


def result(**arrays: Any) -> Result:
    return Result("ok", "", {}, {"time_s": TIMES, **arrays}, BASE)


def test_shares_of_the_impulse_by_which_way_the_beam_slides():
    normal = np.tile([1.0, 2.0, 1.0], (5, 1))
    # The first node slides back, the second slides on, the third is held by half of full friction.
    drag = MU * normal * [1.0, -1.0, 0.5]
    found = strike.sliding(result(node_normal_N=normal, node_friction_N=drag))
    assert found["driving_share"] == pytest.approx(0.25)
    assert found["braking_share"] == pytest.approx(0.5)
    assert found["sticking_share"] == pytest.approx(0.25)
    assert found["friction_over_normal"] == pytest.approx(MU * (1.0 - 2.0 + 0.5) / 4.0)


def test_the_ground_is_looked_at_until_the_middle_passes_the_clamps():
    weight_N = MASS_KG * BASE.robot.gravity_m_s2
    height = np.full((5, 3), 2e-3)
    height[:, 1] = 3e-3, 2.5e-3, 1e-3, 0.0, 0.0
    normal = np.zeros((5, 3))
    normal[:, 1] = weight_N * np.array([0.0, 4.0, 9.0, 0.0, 0.0])
    feet = np.tile(1e-4 * np.array([0.0, 1.0, 5.0, 9.0, 9.0]), (2, 1)).T
    angles = 0.1 * np.arange(5)
    found = strike.pressed(
        result(node_y_m=height, node_normal_N=normal, corner_y_m=feet, clamp_left_rad=angles)
    )
    assert found["load_over_weight"] == pytest.approx(4.0)
    assert found["lift_bar"] == pytest.approx(1e-4 / LENGTH_M)
    assert found["alpha_snap_rad"] == pytest.approx(0.2)


def test_shares_of_an_energy_are_all_of_it():
    vx, vy, climbed_m, turning_J = 0.5, 2.0, 1e-3, 1e-5
    kinetic_J = 0.5 * MASS_KG * (vx**2 + vy**2) + turning_J
    losses = {"friction": 2e-4, "damping": 3e-4, "numerical": 1e-5}
    ended = {f"{kind}_loss_J": np.full(5, value) for kind, value in losses.items()}
    whole_J = kinetic_J + MASS_KG * BASE.robot.gravity_m_s2 * climbed_m + sum(losses.values())
    jump = result(
        com_vx_m_s=np.full(5, vx), com_vy_m_s=np.full(5, vy), com_y_m=climbed_m * TIMES / TIMES[-1],
        kinetic_J=np.full(5, kinetic_J), **ended,
    )  # fmt: skip
    found = strike.energy_shares(jump, whole_J / BASE.robot.scales.energy_J)
    assert sum(found.values()) == pytest.approx(1.0)
    assert found["turning_share"] == pytest.approx(turning_J / whole_J)
    assert found["sideways_share"] == pytest.approx(0.5 * MASS_KG * vx**2 / whole_J)


def test_the_way_of_the_centre_of_mass():
    force = np.ones((5, 2))
    jump = result(com_x_m=2.0 * TIMES, com_y_m=TIMES, node_normal_N=force, corner_normal_N=force)
    found = strike.centre_of_mass(jump)
    assert found["x_bar"] == pytest.approx(2.0 * found["y_bar"])
    assert found["time_ms"][-1] == pytest.approx(4.0) and set(found["ground_force_N"]) == {4.0}
