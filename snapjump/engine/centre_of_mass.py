"""Centre of mass of frame and beam together, and how fast they rotate about it."""

from typing import Any

from snapjump.frame.parts.point_mass import rotation_of
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


@routine
def mean_rotation(model: Any, masses: Any, mesh: Any, state: Any, velocity: Any, about: Any) -> Any:
    """Rate of rotation (rad/T): angular momentum about the centre of mass, whose place and velocity
    ``about`` are, over the moment of inertia. In flight the momentum stays as it is."""
    momentum, square = model.frame.rotation(mesh, state, velocity, about)
    for node in range(masses.shape[0]):
        i = model.discretization.node_dofs() * node + model.frame.dofs(mesh)
        gained, own = rotation_of(masses[node], state, velocity, i, about)
        momentum = momentum + gained
        square = square + own
    return momentum / square
