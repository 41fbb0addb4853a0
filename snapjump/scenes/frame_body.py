"""Frames as bodies: masses and dimensions of leg, top, leg and of what is clamped to them."""

from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.frame.base import Outline


def compression(simulation: Simulation) -> Any:
    """End shortening of the beam over its length: epsilon, and what the inset adds to it; of many
    robots an array.

    Raises ParameterError if that is more than a beam is computed for.
    """
    epsilon, length_m = simulation.design.epsilon, simulation.robot.length_m
    total = epsilon + 2.0 * (simulation.frame.inset_m / length_m)
    if np.any(total > 0.4):
        half = 0.5 * (0.4 - epsilon) * length_m
        raise ParameterError(
            "frame.inset_m",
            simulation.frame.inset_m,
            f"a number in [0, {half:g}] m with design.epsilon = {epsilon:g}",
        )
    return total


def frame_model(simulation: Simulation, mount_height_bar: Any) -> Any:
    """The dimensionless frame whose clamps are ``mount_height_bar`` (in L) above its feet."""
    robot = simulation.robot
    return simulation.frame.body(
        Outline(
            width=1.0 - simulation.design.epsilon,
            height=robot.frame_height_m / robot.length_m,
            mount=mount_height_bar,
            mass=simulation.environment.mass_kg(robot) / robot.scales.mass_kg - 1.0,
            end=simulation.discretization.clamped_mass_bar,
            length_m=robot.length_m,
            mass_kg=robot.scales.mass_kg,
            stretching=robot.stretching_stiffness_bar,
            per_length=simulation.contact.per_length,
        )
    )
