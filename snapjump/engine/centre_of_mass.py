"""Centre of mass of frame and beam together."""

from typing import Any

from snapjump.discretization.base import node_dofs
from snapjump.number.dispatch import routine


@routine
def centre_of_mass(model: Any, masses: Any, state: Any, velocity: Any) -> Any:
    """Position (x, y) and velocity (vx, vy) for a rigid frame with coordinates (x, y, theta)."""
    mass = model.frame.mass
    x = mass * state[0]
    y = mass * state[1]
    vx = mass * velocity[0]
    vy = mass * velocity[1]
    beam = 0.0
    for node in range(masses.shape[0]):
        weight = masses[node]
        i = node_dofs(model.discretization) * node + 3
        x = x + weight * state[i]
        y = y + weight * state[i + 1]
        vx = vx + weight * velocity[i]
        vy = vy + weight * velocity[i + 1]
        beam += weight
    total = mass + beam
    return x / total, y / total, vx / total, vy / total
