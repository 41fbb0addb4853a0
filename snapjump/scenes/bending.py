"""Bending of a recorded beam: strain of its outer fibres and torques of its clamps.

Curvatures are of second order in the element's length: of discrete rods those of their hinges, the
clamps' included, whose moments are in balance with the others; of elements with rotations those in
the elements' middles, carried to the nodes.
"""

from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.read_out import Readings
from snapjump.scenes.runner import March


def bending_arrays(march: March, nodes: Array, readings: Readings) -> dict[str, Array]:
    """Bending strain at the chain's nodes (S, N + 1), positive where the beam is bent upward, and
    torques of the clamps on the beam (S), in N m, in the sense in which they turn.

    nodes (S, D): the chain's coordinates."""
    robot, beam = march.simulation.robot, march.models[0].discretization
    elements = march.simulation.discretization.elements
    bent = curvatures(beam, elements, nodes, readings.tangents.reshape(-1, 2, 2))
    unit_N_m = march.scales.energy_J
    return {
        "node_strain": 0.5 * robot.thickness_m / robot.length_m * bent,
        "clamp_left_torque_N_m": readings.torques[:, 0] * unit_N_m,
        "clamp_right_torque_N_m": readings.torques[:, 1] * unit_N_m,
    }


def place_bar(discretization: Any, node: int) -> float:
    """Where a node of the chain is, along the beam from the left clamp, in L."""
    elements, moving = discretization.elements, discretization.moving_elements
    return float((node + 0.5 * (elements - moving)) / elements)


def curvatures(beam: Any, elements: int, nodes: Array, tangents: Array) -> Array:
    """Curvatures (S, N + 1), in 1/L, of chains (S, D) between clamps of directions (S, 2, 2)."""
    if beam.node_dofs() == 3:
        return of_rotations(elements * nodes[:, 2::3] / beam.rotation_length())
    places = np.stack([nodes[:, 0::2], nodes[:, 1::2]], axis=-1)
    bent = elements * turning(places, tangents)
    if beam.clamp_distance() == 0.0:
        bent[:, [0, -1]] *= 2.0  # half an element's turning
    return bent


def of_rotations(turned: Array) -> Array:
    """Curvatures (S, N + 1) of nodes whose rotations over an element's length are given: between
    those in the middle of two elements, and beyond them at the ends."""
    middles = np.diff(turned, axis=1)
    first, last = 2.0 * middles[:, :1] - middles[:, 1:2], 2.0 * middles[:, -1:] - middles[:, -2:-1]
    outer = np.concatenate([first, middles, last], axis=1)
    return 0.5 * (outer[:, :-1] + outer[:, 1:])


def turning(places: Array, tangents: Array) -> Array:
    """Turning (S, N + 1) of chains of nodes (S, N + 1, 2) at each, between clamps of these
    directions (S, 2, 2): 2 tan(phi/2), as discrete rods have it."""
    edges = np.diff(places, axis=1)
    edges /= np.sqrt((edges * edges).sum(axis=2, keepdims=True))
    directions = np.concatenate([tangents[:, :1], edges, tangents[:, 1:]], axis=1)
    before, after = directions[:, :-1], directions[:, 1:]
    across = before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0]
    turned: Array = 2.0 * across / (1.0 + (before * after).sum(axis=2))
    return turned
