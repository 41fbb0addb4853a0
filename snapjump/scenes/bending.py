"""Bending of a recorded beam: strain of its outer fibres and torques of its clamps."""

from typing import Any

from snapjump.arrays import Array
from snapjump.composition import Simulation
from snapjump.engine.read_out import Readings
from snapjump.scenes.runner import March


def strain_per_turning(simulation: Simulation) -> Any:
    """Bending strain of the outer fibres where a beam turns by 1 over an element's length."""
    robot = simulation.robot
    return 0.5 * robot.thickness_m / robot.length_m * simulation.discretization.elements


def clamped_bar(discretization: Any) -> float:
    """How much of the beam lies between a clamp and its first node that moves, in L."""
    return 0.5 * (1.0 - discretization.moving_elements / discretization.elements)


def bending_arrays(march: March, readings: Readings) -> dict[str, Array]:
    """Bending strain at the chain's nodes (S, N + 1), positive where the beam is bent upward, and
    torques of the clamps on the beam (S), in N m, in the sense in which they turn."""
    unit_N_m = march.scales.energy_J
    return {
        "node_strain": strain_per_turning(march.simulation) * readings.turnings,
        "clamp_left_torque_N_m": readings.torques[:, 0] * unit_N_m,
        "clamp_right_torque_N_m": readings.torques[:, 1] * unit_N_m,
    }
