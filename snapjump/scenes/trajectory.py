"""A recorded march as arrays in SI units, with contact forces and the energy ledger."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import ROTARY_INERTIA
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.model import Model, numbers_of
from snapjump.engine.points import point_count
from snapjump.engine.read_out import CORNERS, Readings, read_states
from snapjump.engine.recorder.trajectory import TrajectoryRecorder
from snapjump.frame.base import Mesh
from snapjump.scenes.bending import bending_arrays
from snapjump.scenes.ground_impulse import impulse_arrays
from snapjump.scenes.runner import March

Array = NDArray[np.float64]


class Samples(NamedTuple):
    """Times (S), states and velocities (S, D), works (S, 5)."""

    times: Array
    states: Array
    velocities: Array
    works: Array


def samples_of(march: March, recorder: TrajectoryRecorder) -> Samples:
    """What a recorder has kept, and the march's last state."""
    count = int(recorder.filled[0])
    times, states = recorder.times[:count], recorder.states[:count]
    velocities, works = recorder.velocities[:count], recorder.works[:count]
    # The last step has no sample where it ended too soon after the one before.
    if recorder.clock[0] > times[-1]:
        times = np.append(times, recorder.clock[0])
        states = np.vstack([states, march.memory.start[:, 0]])
        velocities = np.vstack([velocities, march.memory.velocity[0, :, 0]])
        works = np.vstack([works, recorder.totals])
    return Samples(times, states, velocities, works)


def trajectory_arrays(march: March, samples: Samples) -> dict[str, Array]:
    """Everything that ``trajectory.npz`` holds; S samples, N + 1 nodes, 4 corners."""
    model, scales = march.model, march.scales
    times, states, velocities, works = samples
    dofs = model.frame.dofs(march.mesh)
    stride = model.discretization.node_dofs()
    nodes, speeds = states[:, dofs:], velocities[:, dofs:]
    readings = read(march, times, states, velocities)
    arrays = {
        "time_s": (times + model.clamp.time_turned()) * scales.time_s,
        "node_x_m": nodes[:, 0::stride] * scales.length_m,
        "node_y_m": nodes[:, 1::stride] * scales.length_m,
        "node_vx_m_s": speeds[:, 0::stride] * scales.velocity_m_s,
        "node_vy_m_s": speeds[:, 1::stride] * scales.velocity_m_s,
        "clamp_left_rad": readings.angles[:, 0].copy(),
        "clamp_right_rad": readings.angles[:, 1].copy(),
    }
    if dofs:
        arrays |= frame_arrays(march, states, velocities, readings)
    if model.contact.exists():
        arrays |= contact_arrays(march, states, readings)
        arrays |= impulse_arrays(march, times, states, velocities)
    if model.discretization.has_elements():
        arrays |= bending_arrays(march, readings)
    arrays |= energy_arrays(march, states, velocities, works, readings)
    return arrays


def read(march: March, times: Array, states: Array, velocities: Array) -> Readings:
    """What is read off states and velocities (S, D) at times (S) of a march's first robot."""
    model, masses, mesh = march.model, march.masses, march.mesh
    points, nodes = point_count(model, masses, mesh), len(masses)
    shapes = ((), (), (2,), (4,), (CORNERS, 2), (points,), (points,), (points,), (nodes,), (2,))
    readings = Readings(*(np.zeros((len(times), *shape)) for shape in shapes))
    read_states(model, numbers_of(model), masses, mesh, times, states, velocities, readings)
    return readings


def frame_arrays(
    march: March, states: Array, velocities: Array, readings: Readings
) -> dict[str, Array]:
    """Pose of the frame, its corners, and the centre of mass of frame and beam."""
    scales = march.scales
    x, y, vx, vy = centre_of_mass(march.model, march.masses, march.mesh, states.T, velocities.T)
    frame_x, frame_y, sine, cosine = readings.pose.T
    corners = readings.corners
    return {
        "frame_x_m": frame_x * scales.length_m,
        "frame_y_m": frame_y * scales.length_m,
        "frame_angle_rad": np.unwrap(np.arctan2(sine, cosine)),
        "corner_x_m": corners[:, :, 0] * scales.length_m,
        "corner_y_m": corners[:, :, 1] * scales.length_m,
        "com_x_m": x * scales.length_m,
        "com_y_m": y * scales.length_m,
        "com_vx_m_s": vx * scales.velocity_m_s,
        "com_vy_m_s": vy * scales.velocity_m_s,
    }


def contact_arrays(march: March, states: Array, readings: Readings) -> dict[str, Array]:
    """Gaps, normal forces and friction (along +x) at the beam's nodes and at the frame's corners.

    They are of the samples' instants: what they add up to is no impulse.

    Slave nodes have no forces; a node of an elastic frame counts to the nearest corner. The forces
    of a constraint are none of the state, and are left out.
    """
    model, mesh = march.model, march.mesh
    scales, frame, nodes = march.scales, model.frame, len(march.masses)
    gaps = readings.gap
    belongs = np.zeros((gaps.shape[1] - nodes, 0))
    arrays = {"node_gap_m": gaps[:, :nodes] * scales.length_m}
    if frame.dofs(mesh):
        belongs = nearest_corners(model, mesh, states[0])
        lowest = [gaps[:, nodes:][:, of].min(axis=1) for of in belongs.T]
        arrays["corner_gap_m"] = np.column_stack(lowest) * scales.length_m
    if model.contact.is_constraint():
        return arrays
    for name, forces in (("normal", readings.normal), ("friction", readings.friction)):
        arrays[f"node_{name}_N"] = forces[:, :nodes] * scales.force_N
        if frame.dofs(mesh):
            arrays[f"corner_{name}_N"] = forces[:, nodes:] @ belongs * scales.force_N
    return arrays


def nearest_corners(model: Model, mesh: Mesh, state: Array) -> NDArray[np.bool_]:
    """Which of the frame's four corners each of its points counts to, (points, 4)."""
    frame = model.frame
    points = range(frame.contact_points(mesh))
    places = np.array([frame.contact_point(mesh, k, state, state)[:2] for k in points])
    corners = np.array([frame.corner_point(mesh, k, state, state)[:2] for k in range(CORNERS)])
    distances = np.linalg.norm(places[:, None] - corners, axis=2)
    return np.argmin(distances, axis=1)[:, None] == np.arange(CORNERS)


def energy_arrays(
    march: March, states: Array, velocities: Array, works: Array, readings: Readings
) -> dict[str, Array]:
    """The ledger: stored energies, works and losses since the beginning, in J.

    What the integrator itself dissipated is what the other entries leave unexplained.
    """
    model, mesh, masses = march.model, march.mesh, march.masses
    dofs = model.frame.dofs(mesh)
    stride = model.discretization.node_dofs()
    weights = np.outer(masses, [1.0, 1.0, ROTARY_INERTIA][:stride]).ravel()
    kinetic = 0.5 * (velocities[:, dofs:] ** 2) @ weights
    fall = model.load.gravity()
    tug = model.load.pull()
    potential = (fall * states[:, dofs + 1 :: stride] - tug * states[:, dofs::stride]) @ masses
    for k in range(dofs):
        mass = float(model.frame.mass_of(mesh, k))
        kinetic = kinetic + 0.5 * mass * velocities[:, k] ** 2
    if dofs:
        along, across = model.frame.moments(mesh, states.T)
        potential = potential + fall * across - tug * along
    elastic, contact = readings.elastic, readings.contact
    stored = elastic + kinetic + potential + contact
    friction, damping, clamps, impacts, drag = works.T
    numerical = stored[0] + clamps - friction - damping - impacts - drag - stored
    ledger = {
        "elastic_J": elastic,
        "kinetic_J": kinetic,
        "gravitational_J": potential,
        "contact_J": contact,
        "clamp_work_J": clamps,
        "friction_loss_J": friction,
        "damping_loss_J": damping,
        "contact_loss_J": impacts,
        "drag_loss_J": drag,
        "numerical_loss_J": numerical,
    }
    energy_J = march.scales.energy_J
    return {name: values * energy_J for name, values in ledger.items()}
