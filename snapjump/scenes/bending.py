"""Bending of a recorded beam: strain of its outer fibres and torques of its clamps.

Curvatures are those of polygons through the nodes, of second order in the element's length. At a
clamp that of discrete rods is what the hinge there has, whose moment is in balance with the others;
of elements with rotations, whose nodes lie on the curve, it is taken from two chords.
"""

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.read_out import Readings
from snapjump.scenes.runner import March

ENDS, NEXT = [0, -1], [1, -2]


def bending_arrays(march: March, nodes: Array, readings: Readings) -> dict[str, Array]:
    """Bending strain at the chain's nodes (S, N + 1), positive where the beam is bent upward, and
    torques of the clamps on the beam (S), in N m, in the sense in which they turn.

    nodes (S, D): the chain's coordinates."""
    model, robot = march.models[0], march.simulation.robot
    stride = model.discretization.node_dofs()
    places = np.stack([nodes[:, 0::stride], nodes[:, 1::stride]], axis=-1)
    length = 1.0 / march.simulation.discretization.elements
    bent = turning(places, readings.tangents.reshape(-1, 2, 2)) / length
    if stride == 3:
        bent[:, ENDS] = 3.0 * bent[:, ENDS] - 0.5 * bent[:, NEXT]
    elif model.discretization.clamp_distance() == 0.0:
        bent[:, ENDS] *= 2.0  # half an element's turning
    unit_N_m = march.scales.energy_J
    return {
        "node_strain": 0.5 * robot.thickness_m / robot.length_m * bent,
        "clamp_left_torque_N_m": readings.torques[:, 0] * unit_N_m,
        "clamp_right_torque_N_m": readings.torques[:, 1] * unit_N_m,
    }


def turning(places: Array, tangents: Array) -> Array:
    """Angles (S, N + 1) by which chains of nodes (S, N + 1, 2) turn at each, between clamps of
    these directions (S, 2, 2)."""
    edges = np.diff(places, axis=1)
    edges /= np.linalg.norm(edges, axis=2, keepdims=True)
    directions = np.concatenate([tangents[:, :1], edges, tangents[:, 1:]], axis=1)
    before, after = directions[:, :-1], directions[:, 1:]
    across = before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0]
    turned: Array = np.arctan2(across, (before * after).sum(axis=2))
    return turned
