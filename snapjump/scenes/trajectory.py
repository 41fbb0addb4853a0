"""A recorded march as arrays in SI units, with contact forces and the energy ledger."""

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.contact.base import Approach, force_if_acting
from snapjump.discretization.base import TURN_INERTIA
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.model import Model
from snapjump.frame.base import STILL
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
    dofs = model.frame.dofs(march.mesh)
    stride = model.discretization.node_dofs()
    nodes, speeds = states[:, dofs:], velocities[:, dofs:]
    begun = model.clamp.start / model.clamp.rate if model.clamp.rate else 0.0
    angles = [model.clamp.angles(t) for t in times]
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
        arrays |= frame_arrays(march, states, velocities)
    if model.contact.exists():
        arrays |= contact_arrays(march, states, velocities)
        if dofs:
            arrays |= frame_contact_arrays(march, states, velocities)
    arrays |= energy_arrays(march, times, states, velocities, works)
    return arrays


def frame_arrays(march: March, states: Array, velocities: Array) -> dict[str, Array]:
    """Pose of the frame, its corners, and the centre of mass of frame and beam."""
    model, mesh, masses = march.models[0], march.mesh, march.masses
    scales = march.simulation.robot.scales
    rows = list(zip(states, velocities, strict=True))
    boxes = [model.frame.box(mesh, q, v) for q, v in rows]
    angle = np.unwrap([np.arctan2(float(b.sine), float(b.cosine)) for b in boxes])
    x, y, vx, vy = centre_of_mass(model, masses, mesh, states.T, velocities.T)
    corners = np.array(
        [[model.frame.corner_point(mesh, k, q, v)[:2] for k in range(4)] for q, v in rows]
    )
    return {
        "frame_x_m": np.array([b.x for b in boxes]) * scales.length_m,
        "frame_y_m": np.array([b.y for b in boxes]) * scales.length_m,
        "frame_angle_rad": angle,
        "corner_x_m": corners[:, :, 0] * scales.length_m,
        "corner_y_m": corners[:, :, 1] * scales.length_m,
        "com_x_m": x * scales.length_m,
        "com_y_m": y * scales.length_m,
        "com_vx_m_s": vx * scales.velocity_m_s,
        "com_vy_m_s": vy * scales.velocity_m_s,
    }


def frame_contact_arrays(march: March, states: Array, velocities: Array) -> dict[str, Array]:
    """Gaps and forces at the frame's corners; a node of an elastic frame counts to the nearest."""
    model, mesh = march.models[0], march.mesh
    frame, scales = model.frame, march.simulation.robot.scales
    count = frame.contact_points(mesh)
    points = np.array(
        [
            [frame.contact_point(mesh, k, q, v) for k in range(count)]
            for q, v in zip(states, velocities, strict=True)
        ]
    )
    weights = np.array([frame.point_share(mesh, k, model.ground) for k in range(count)])
    first = points[0, :, :2]
    corners = np.array([frame.corner_point(mesh, k, states[0], states[0])[:2] for k in range(4)])
    nearest = np.argmin(np.linalg.norm(first[:, None] - corners, axis=2), axis=1)
    belongs = (nearest[:, None] == np.arange(4)) * weights[:, None]
    gaps = [points[:, nearest == k, 1].min(axis=1) for k in range(4)]
    arrays = {"corner_gap_m": np.column_stack(gaps) * scales.length_m}
    if model.contact.is_impulsive():
        return arrays
    slides, speeds = points[:, :, 2], points[:, :, 3]
    normal, drag = point_forces(model, points[:, :, 1], slides, speeds, 1.0)
    return {
        **arrays,
        "corner_normal_N": normal @ belongs * scales.force_N,
        "corner_friction_N": drag @ belongs * scales.force_N,
    }


def point_forces(
    model: Model, gaps: Array, slides: Array, speeds: Array, weight: float
) -> tuple[Array, Array]:
    """Normal and friction force (EI/L^2) at points of any shape.

    slides, speeds: the points' velocities along and across the ground (L/T).
    """
    normal = np.zeros_like(gaps)
    drag = np.zeros_like(gaps)
    for index in zip(*np.nonzero(gaps < model.contact.reach()), strict=True):
        gap, speed = float(gaps[index]), float(speeds[index])
        _, force, _ = force_if_acting(model.contact, gap, Approach(speed, 0.0, gap, speed, 0.0))
        normal[index] = weight * force
        if model.friction.exists():
            ratio = model.friction.ratio(float(slides[index]))
            drag[index] = -ratio * normal[index]
    return normal, drag


def contact_arrays(march: March, states: Array, velocities: Array) -> dict[str, Array]:
    """Gaps, normal forces and friction (along +x) at the beam's nodes; slave nodes have none.

    The forces of a constraint are none of the state, and are left out.
    """
    model, scales = march.models[0], march.simulation.robot.scales
    dofs = model.frame.dofs(march.mesh)
    stride = model.discretization.node_dofs()
    gaps = states[:, dofs + 1 :: stride]
    arrays = {"node_gap_m": gaps * scales.length_m}
    if model.contact.is_impulsive():
        return arrays
    held = np.where(march.masses > 0.0, gaps, np.inf)
    slides, speeds = velocities[:, dofs::stride], velocities[:, dofs + 1 :: stride]
    normal, drag = point_forces(model, held, slides, speeds, model.ground.node_share)
    return {
        **arrays,
        "node_normal_N": normal * scales.force_N,
        "node_friction_N": drag * scales.force_N,
    }


def stored_contact_energy(march: March, state: Array) -> float:
    """Energy in the barrier (EI/L)."""
    model, mesh = march.models[0], march.mesh
    reach = model.contact.reach()
    heights = state[model.frame.dofs(mesh) + 1 :: model.discretization.node_dofs()]
    points = [
        (model.ground.node_share, gap)
        for mass, gap in zip(march.masses, heights, strict=True)
        if mass > 0.0
    ]
    for k in range(model.frame.contact_points(mesh)):
        gap = model.frame.contact_point(mesh, k, state, state)[1]
        points.append((model.frame.point_share(mesh, k, model.ground), gap))
    return float(sum(w * model.contact.energy(float(g)) for w, g in points if g < reach))


def energy_arrays(
    march: March, times: Array, states: Array, velocities: Array, works: Array
) -> dict[str, Array]:
    """The ledger: stored energies, works and losses since the beginning, in J.

    What the integrator itself dissipated is what the other entries leave unexplained.
    """
    model, mesh, masses = march.models[0], march.mesh, march.masses
    dofs = model.frame.dofs(mesh)
    stride = model.discretization.node_dofs()
    weights = np.outer(masses, [1.0, 1.0, TURN_INERTIA][:stride]).ravel()
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
    elastic = np.zeros(len(times))
    if model.discretization.has_elements():
        for n, (time, state) in enumerate(zip(times, states, strict=True)):
            angles = model.clamp.angles(time)
            tangents = model.frame.end_tangents(mesh, model.load, angles, state, STILL)
            elastic[n] = model.discretization.internal_energy(state[dofs:], tangents)
            elastic[n] += model.frame.energy(mesh, state)
    contact = np.zeros(len(times))
    if model.contact.exists():
        contact = np.array([stored_contact_energy(march, q) for q in states])
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
    energy_J = march.simulation.robot.scales.energy_J
    return {name: values * energy_J for name, values in ledger.items()}
