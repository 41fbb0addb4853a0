"""Impulses of the ground, against closed forms and against forces that can be added up."""

from dataclasses import replace

import numpy as np
import pytest
from physical import DESIGNS, jump, parts_of, run, single_mass

from snapjump.damping.mass_proportional import MassProportional


def impulses(result):
    return (result.arrays[f"ground_impulse_{axis}_N_s"] for axis in "xy")


def test_a_bounce_turns_the_momentum_round():
    result = run(single_mass("bounce", 1e-8))
    along, across = impulses(result)
    scene = result.simulation.sim
    turned = scene.mass_kg * scene.speed_m_s * (1.0 + result.restitution)
    assert across[-1] == pytest.approx(turned, rel=1e-9)
    assert np.abs(along).max() < 1e-12 * turned


@pytest.mark.parametrize("drag", [None, pytest.param(20.0, marks=pytest.mark.compiles)])
def test_a_mass_that_slides_meets_friction_and_bears_its_weight(drag):
    """What drags it without the ground has no part in it."""
    simulation = single_mass("slide", 1e-5, mu=0.3)
    if drag is not None:
        simulation = replace(simulation, damping=MassProportional(drag))
    result = run(simulation)
    along, across = impulses(result)
    time, weight = result.arrays["time_s"], result.simulation.sim.mass_kg * 10.0
    sliding = result.arrays["node_vx_m_s"][:, 0] > 0.01
    assert 100 < sliding.sum() < len(time)
    np.testing.assert_allclose(along[sliding], -0.3 * weight * time[sliding], rtol=1e-6, atol=1e-12)
    np.testing.assert_allclose(across, weight * time, rtol=1e-9, atol=1e-12)


def test_a_jump_has_its_momentum_from_the_ground_and_its_weight():
    result = jump(**parts_of(DESIGNS["baseline"]))
    arrays, simulation = result.arrays, result.simulation
    mass_kg = simulation.environment.mass_kg(simulation.robot)
    time = arrays["time_s"] - arrays["time_s"][0]
    along, across = impulses(result)
    gained = mass_kg * (arrays["com_vx_m_s"] - arrays["com_vx_m_s"][0])
    np.testing.assert_allclose(along, gained, atol=1e-12 * np.abs(gained).max())
    gained = mass_kg * (arrays["com_vy_m_s"] - arrays["com_vy_m_s"][0] + 10.0 * time)
    np.testing.assert_allclose(across, gained, atol=1e-12 * gained.max())


def test_normal_forces_of_many_samples_add_up_to_the_impulse():
    fine = {"sim": jump().simulation.sim.changed(sample_interval_s=6e-7)}
    result = jump(**parts_of(DESIGNS["light"]), **fine)
    forces = result.arrays["node_normal_N"].sum(1) + result.arrays["corner_normal_N"].sum(1)
    _, across = impulses(result)
    assert across[-1] == pytest.approx(np.trapezoid(forces, result.arrays["time_s"]), rel=1e-3)
