"""What is read off many states of a robot: energies, angles, the frame's pose, contact forces."""

from typing import Any, NamedTuple

from snapjump.engine.assemble import Motion
from snapjump.engine.bending import fill_turnings
from snapjump.engine.model import with_numbers
from snapjump.engine.points import (
    Touch,
    friction_force,
    normal_force,
    point_at,
    point_count,
    share_of,
)
from snapjump.engine.powers import held_beam
from snapjump.number.array import uncounted
from snapjump.number.dispatch import compiled, kernel

CORNERS = 4


class Readings(NamedTuple):
    """Arrays of S states and P points that can touch the ground, to be filled.

    elastic, stored in contact: energies (S), in EI/L; angles: of the clamps (S, 2), in rad; pose:
    x, y, sine and cosine of the frame (S, 4); corners: places (S, 4, 2), in L; gap (S, P), in L;
    normal, friction: forces of the ground (S, P), in EI/L^2, zero at points without a share;
    turnings: of the beam at its N + 1 nodes over an element's length (S, N + 1); torques: of both
    clamps on the beam (S, 2), in EI/L.
    """

    elastic: Any
    contact: Any
    angles: Any
    pose: Any
    corners: Any
    gap: Any
    normal: Any
    friction: Any
    turnings: Any
    torques: Any


@compiled
def read_states(
    template: Any,
    numbers: Any,
    masses: Any,
    mesh: Any,
    times: Any,
    states: Any,
    velocities: Any,
    readings: Readings,
) -> None:
    """Fill the readings of states and velocities (S, D) at times (S)."""
    model = with_numbers(template, uncounted(numbers))
    masses, mesh = uncounted(masses), uncounted(mesh)
    states, velocities = uncounted(states), uncounted(velocities)
    readings = uncounted(readings)
    for n in range(times.shape[0]):
        state, velocity = states[n], velocities[n]
        angles = model.clamp.angles(times[n])
        readings.angles[n, 0] = angles.left
        readings.angles[n, 1] = angles.right
        if model.discretization.has_elements():
            read_beam(model, mesh, n, state, velocity, angles, readings)
        if model.frame.dofs(mesh) > 0:
            read_frame(model, mesh, n, state, velocity, readings)
        if model.contact.exists():
            read_contact(model, masses, mesh, n, state, velocity, readings)


@kernel
def elastic_energy(model: Any, mesh: Any, state: Any, tangents: Any) -> Any:
    """Elastic energy of beam and frame (EI/L); ``tangents``: the directions of the clamps."""
    chain = state[model.frame.dofs(mesh) :]
    beam = model.discretization.internal_energy(chain, tangents)
    return beam + model.frame.energy(mesh, state)


@kernel
def read_beam(
    model: Any, mesh: Any, n: Any, state: Any, velocity: Any, angles: Any, readings: Any
) -> None:
    """Fill the elastic energy, the beam's turning and the torques of the clamps."""
    held = held_beam(model, mesh, angles, state, velocity)
    readings.elastic[n] = elastic_energy(model, mesh, state, held.tangents)
    chain = state[model.frame.dofs(mesh) :]
    fill_turnings(model.discretization, chain, held.tangents, readings.turnings[n])
    readings.torques[n, 0] = held.left
    readings.torques[n, 1] = held.right


@kernel
def read_frame(model: Any, mesh: Any, n: Any, state: Any, velocity: Any, readings: Any) -> None:
    """Fill the pose and corners of a frame that moves."""
    box = model.frame.box(mesh, state, velocity)
    readings.pose[n, 0] = box.x
    readings.pose[n, 1] = box.y
    readings.pose[n, 2] = box.sine
    readings.pose[n, 3] = box.cosine
    for k in range(CORNERS):
        x, y, _, _ = model.frame.corner_point(mesh, k, state, velocity)
        readings.corners[n, k, 0] = x
        readings.corners[n, k, 1] = y


@kernel
def read_contact(
    model: Any, masses: Any, mesh: Any, n: Any, state: Any, velocity: Any, readings: Any
) -> None:
    """Fill gaps, forces and stored energy of the points that can touch the ground."""
    still = Motion(0.0, 0.0, 0.0, 0.0)
    stored = 0.0
    for k in range(point_count(model, masses, mesh)):
        point = point_at(model, masses, mesh, k, state, velocity)
        share = share_of(model, masses, mesh, k)
        readings.gap[n, k] = point.gap
        if point.gap < model.contact.reach() and share > 0.0:
            touch = Touch(point, point, 0.0, share)
            readings.normal[n, k] = share * normal_force(model, still, touch)
            if model.friction.exists():
                readings.friction[n, k] = -share * friction_force(model, still, touch)
            stored += share * model.contact.energy(point.gap)
    readings.contact[n] = stored
