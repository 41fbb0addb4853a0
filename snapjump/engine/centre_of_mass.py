"""Centre of mass of frame and beam together."""

from typing import Any

from snapjump.discretization.base import node_dofs
from snapjump.frame.base import frame_dofs, frame_moments
from snapjump.number.dispatch import routine


@routine
def centre_of_mass(model: Any, masses: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    """Position (x, y) and velocity (vx, vy)."""
    mass = model.frame.mass
    x, y = frame_moments(model.frame, mesh, state)
    vx, vy = frame_moments(model.frame, mesh, velocity)
    beam = 0.0
    for node in range(masses.shape[0]):
        weight = masses[node]
        i = node_dofs(model.discretization) * node + frame_dofs(model.frame, mesh)
        x = x + weight * state[i]
        y = y + weight * state[i + 1]
        vx = vx + weight * velocity[i]
        vy = vy + weight * velocity[i + 1]
        beam += weight
    total = mass + beam
    return x / total, y / total, vx / total, vy / total
