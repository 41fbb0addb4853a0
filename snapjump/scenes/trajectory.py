"""A recorded march as arrays in SI units, with contact forces and the energy ledger."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.clamp.base import clamp_angles
from snapjump.composition import Simulation
from snapjump.contact.base import (
    Approach,
    contact_energy,
    contact_reach,
    contact_weights,
    force_if_acting,
    has_contact,
    is_impulsive,
)
from snapjump.discretization.base import TURN_INERTIA, has_elements, internal_energy, node_dofs
from snapjump.engine.model import Model
from snapjump.frame.base import corner_point, end_tangents, frame_dofs, frame_mass
from snapjump.friction.base import has_friction, slip
from snapjump.load.base import gravity, pull
from snapjump.scenes.runner import March

Array = NDArray[np.float64]


def samples_of(march: March) -> tuple[Array, Array, Array, Array]:
    """Times (S), states and velocities (S, D), works (S, 4), the march's last state included."""
    recorder = march.recorder
    count = int(recorder.filled[0])
    times, states = recorder.times[:count], recorder.states[:count]
    velocities, works = recorder.velocities[:count], recorder.works[:count]
    # The lane's clock has been reset if the march is over; the recorder's has not.
    if recorder.clock[0] > times[-1]:
        times = np.append(times, recorder.clock[0])
        states = np.vstack([states, march.memory.start[:, 0]])
        velocities = np.vstack([velocities, march.memory.velocity[0, :, 0]])
        works = np.vstack([works, recorder.totals])
    return times, states, velocities, works


def trajectory_arrays(simulation: Simulation, model: Model, march: March) -> dict[str, Array]:
    """Everything that ``trajectory.npz`` holds; S samples, N + 1 nodes, 4 corners."""
    scales = simulation.robot.scales
    times, states, velocities, works = samples_of(march)
    dofs = frame_dofs(model.frame)
    stride = node_dofs(model.discretization)
    nodes, speeds = states[:, dofs:], velocities[:, dofs:]
    begun = model.clamp.start / model.clamp.rate if model.clamp.rate else 0.0
    angles = [clamp_angles(model.clamp, t) for t in times]
    arrays = {
        "time_s": (times + begun) * scales.time_s,
        "node_x_m": nodes[:, 0::stride] * scales.length_m,
        "node_y_m": nodes[:, 1::stride] * scales.length_m,
        "node_vx_m_s": speeds[:, 0::stride] * scales.velocity_m_s,
        "node_vy_m_s": speeds[:, 1::stride] * scales.velocity_m_s,
        "clamp_left_rad": np.array([float(a.left) for a in angles]),
        "clamp_right_rad": np.array([float(a.right) for a in angles]),
    }
    if dofs:
        arrays |= frame_arrays(model, march.masses, states, velocities, scales)
    if has_contact(model.contact):
        arrays |= contact_arrays(model, march.masses, states, velocities, scales)
    arrays |= energy_arrays(model, march.masses, times, states, velocities, works, scales)
    return arrays


def frame_arrays(
    model: Model, masses: Array, states: Array, velocities: Array, scales: Any
) -> dict[str, Array]:
    """Pose of the frame, its corners, and the centre of mass of frame and beam."""
    stride = node_dofs(model.discretization)
    weights = np.concatenate([[model.frame.mass], masses])
    xs = np.column_stack([states[:, 0], states[:, 3::stride]])
    ys = np.column_stack([states[:, 1], states[:, 4::stride]])
    vxs = np.column_stack([velocities[:, 0], velocities[:, 3::stride]])
    vys = np.column_stack([velocities[:, 1], velocities[:, 4::stride]])
    share = weights / weights.sum()
    corners = np.array(
        [
            [corner_point(model.frame, k, q, v)[:2] for k in range(4)]
            for q, v in zip(states, velocities, strict=True)
        ]
    )
    return {
        "frame_x_m": states[:, 0] * scales.length_m,
        "frame_y_m": states[:, 1] * scales.length_m,
        "frame_angle_rad": states[:, 2].copy(),
        "corner_x_m": corners[:, :, 0] * scales.length_m,
        "corner_y_m": corners[:, :, 1] * scales.length_m,
        "com_x_m": xs @ share * scales.length_m,
        "com_y_m": ys @ share * scales.length_m,
        "com_vx_m_s": vxs @ share * scales.velocity_m_s,
        "com_vy_m_s": vys @ share * scales.velocity_m_s,
    }


def point_forces(
    model: Model, gaps: Array, slides: Array, speeds: Array, weight: float
) -> tuple[Array, Array]:
    """Normal and friction force (EI/L^2) at points of any shape.

    slides, speeds: the points' velocities along and across the ground (L/T).
    """
    normal = np.zeros_like(gaps)
    drag = np.zeros_like(gaps)
    for index in zip(*np.nonzero(gaps < contact_reach(model.contact)), strict=True):
        gap, speed = float(gaps[index]), float(speeds[index])
        _, force, _ = force_if_acting(model.contact, gap, Approach(speed, 0.0, gap, speed, 0.0))
        normal[index] = weight * force
        if has_friction(model.friction):
            ratio, _ = slip(model.friction, float(slides[index]), 0.0)
            drag[index] = -ratio * normal[index]
    return normal, drag


def contact_arrays(
    model: Model, masses: Array, states: Array, velocities: Array, scales: Any
) -> dict[str, Array]:
    """Gaps, normal forces and friction (along +x) at nodes and corners; slave nodes have none.

    The forces of a constraint are none of the state, and are left out.
    """
    dofs = frame_dofs(model.frame)
    stride = node_dofs(model.discretization)
    by_node, by_corner = contact_weights(model.contact)
    gaps = states[:, dofs + 1 :: stride]
    held = np.where(masses > 0.0, gaps, np.inf)
    places = {
        "node": (held, velocities[:, dofs::stride], velocities[:, dofs + 1 :: stride], by_node)
    }
    arrays = {"node_gap_m": gaps * scales.length_m}
    if dofs:
        points = np.array(
            [
                [corner_point(model.frame, k, q, v) for k in range(4)]
                for q, v in zip(states, velocities, strict=True)
            ]
        )
        places["corner"] = (points[:, :, 1], points[:, :, 2], points[:, :, 3], by_corner)
        arrays["corner_gap_m"] = points[:, :, 1] * scales.length_m
    if is_impulsive(model.contact):
        return arrays
    for name, (heights, slides, speeds, weight) in places.items():
        normal, drag = point_forces(model, heights, slides, speeds, weight)
        arrays[f"{name}_normal_N"] = normal * scales.force_N
        arrays[f"{name}_friction_N"] = drag * scales.force_N
    return arrays


def stored_contact_energy(model: Model, masses: Array, state: Array) -> float:
    """Energy in the barrier (EI/L)."""
    dofs = frame_dofs(model.frame)
    by_node, by_corner = contact_weights(model.contact)
    reach = contact_reach(model.contact)
    heights = state[dofs + 1 :: node_dofs(model.discretization)]
    points = [(by_node, gap) for mass, gap in zip(masses, heights, strict=True) if mass > 0.0]
    if dofs:
        points += [(by_corner, corner_point(model.frame, k, state, state)[1]) for k in range(4)]
    return float(sum(w * contact_energy(model.contact, float(g)) for w, g in points if g < reach))


def energy_arrays(
    model: Model,
    masses: Array,
    times: Array,
    states: Array,
    velocities: Array,
    works: Array,
    scales: Any,
) -> dict[str, Array]:
    """The ledger: stored energies, works and losses since the beginning, in J.

    What the integrator itself dissipated is what the other entries leave unexplained.
    """
    dofs = frame_dofs(model.frame)
    stride = node_dofs(model.discretization)
    weights = np.outer(masses, [1.0, 1.0, TURN_INERTIA][:stride]).ravel()
    kinetic = 0.5 * (velocities[:, dofs:] ** 2) @ weights
    fall = gravity(model.load)
    tug = pull(model.load)
    potential = (fall * states[:, dofs + 1 :: stride] - tug * states[:, dofs::stride]) @ masses
    for k in range(dofs):
        kinetic = kinetic + 0.5 * float(frame_mass(model.frame, k)) * velocities[:, k] ** 2
    if dofs:
        potential = potential + fall * model.frame.mass * states[:, 1]
    elastic = np.zeros(len(times))
    if has_elements(model.discretization):
        for n, (time, state) in enumerate(zip(times, states, strict=True)):
            angles = clamp_angles(model.clamp, time)
            tangents = end_tangents(model.frame, model.load, angles, state, 0.0)
            elastic[n] = internal_energy(model.discretization, state[dofs:], tangents)
    contact = np.zeros(len(times))
    if has_contact(model.contact):
        contact = np.array([stored_contact_energy(model, masses, q) for q in states])
    stored = elastic + kinetic + potential + contact
    friction, damping, clamps, impacts = works.T
    numerical = stored[0] + clamps - friction - damping - impacts - stored
    ledger = {
        "elastic_J": elastic,
        "kinetic_J": kinetic,
        "gravitational_J": potential,
        "contact_J": contact,
        "clamp_work_J": clamps,
        "friction_loss_J": friction,
        "damping_loss_J": damping,
        "contact_loss_J": impacts,
        "numerical_loss_J": numerical,
    }
    return {name: values * scales.energy_J for name, values in ledger.items()}
