"""The recorder's two figures, against the trajectory of the same jump and known functions."""

import numpy as np
import pytest

from snapjump.composition import with_tier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.scenes.between_steps import crossing
from snapjump.scenes.observed import observe_jump
from snapjump.sim.jump import Jump
from snapjump.simulation import simulate
from snapjump.stepping.adaptive import AdaptiveStep


@pytest.mark.slow
@pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])
def test_observables_are_those_of_the_trajectory(clamp):
    simulation = with_tier(
        "draft",
        stepping=AdaptiveStep(tolerance=1e-5),
        discretization=DiscreteElasticRod(elements=17, clamp=clamp),
        sim=Jump(sample_interval_s=2.0e-7, time_limit_s=0.03),
    )
    seen, jump = observe_jump(simulation), simulate(simulation)
    assert seen["x_bar"] == jump.x_bar and seen["y_bar"] == jump.y_bar
    arrays = jump.arrays
    forces = arrays["node_normal_N"].sum(axis=1) + arrays["corner_normal_N"].sum(axis=1)
    assert seen["peak_force_N"] == pytest.approx(forces.max(), rel=0.02)
    assert seen["peak_force_N"] >= forces.max() * (1.0 - 1e-12)
    # The frame's mounts, from its corners: the feet, and the mount height above them.
    angle, nodes = arrays["frame_angle_rad"], jump.nodes_m()
    up = np.stack([-np.sin(angle), np.cos(angle)], axis=1)
    feet = np.stack([arrays["corner_x_m"][:, 0], arrays["corner_y_m"][:, 0]], axis=1)
    last = nodes.shape[1] - 1
    middle = 0.5 * (nodes[:, last // 2] + nodes[:, (last + 1) // 2])
    mount_m = seen["mount_height_bar"] * simulation.robot.length_m
    heights = np.sum((middle - feet) * up, axis=1) - mount_m
    assert seen["snap_time_s"] == pytest.approx(crossing(arrays["time_s"], heights), rel=1e-9)
