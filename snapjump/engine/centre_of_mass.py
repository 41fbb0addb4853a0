"""Centre of mass of frame and beam together, and how fast they rotate about it."""

from typing import Any

from snapjump.frame.parts.point_mass import rotation_of
from snapjump.number.dispatch import routine


@routine
def whole_mass(model: Any, masses: Any, mesh: Any) -> Any:
    """Mass of frame and beam (rho A L)."""
    beam = 0.0
    for node in range(masses.shape[0]):
        beam += masses[node]
    return model.frame.whole_mass(mesh) + beam


@routine
def mean_of(model: Any, masses: Any, mesh: Any, vector: Any) -> Any:
    """What frame and beam have of a vector of all coordinates, by mass: (x, y)."""
    x, y = model.frame.moments(mesh, vector)
    for node in range(masses.shape[0]):
        weight = masses[node]
        i = model.discretization.node_dofs() * node + model.frame.dofs(mesh)
        x = x + weight * vector[i]
        y = y + weight * vector[i + 1]
    total = whole_mass(model, masses, mesh)
    return x / total, y / total


@routine
def centre_of_mass(model: Any, masses: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    """Position (x, y) and velocity (vx, vy)."""
    x, y = mean_of(model, masses, mesh, state)
    vx, vy = mean_of(model, masses, mesh, velocity)
    return x, y, vx, vy


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
