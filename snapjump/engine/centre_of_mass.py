"""Centre of mass of frame and beam together."""

from typing import Any

from snapjump.number.dispatch import routine


@routine
def centre_of_mass(model: Any, masses: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    """Position (x, y) and velocity (vx, vy)."""
    mass = model.frame.mass
    x, y = model.frame.moments(mesh, state)
    vx, vy = model.frame.moments(mesh, velocity)
    beam = 0.0
    for node in range(masses.shape[0]):
        weight = masses[node]
        i = model.discretization.node_dofs() * node + model.frame.dofs(mesh)
        x = x + weight * state[i]
        y = y + weight * state[i + 1]
        vx = vx + weight * velocity[i]
        vy = vy + weight * velocity[i + 1]
        beam += weight
    total = mass + beam
    return x / total, y / total, vx / total, vy / total
