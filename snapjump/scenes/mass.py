"""Verification: one mass on the ground, bouncing in the barrier or sliding to rest."""

import math
import time
from typing import Any

import numpy as np

from snapjump.clamp.constant_rate import ConstantRate
from snapjump.composition import Simulation
from snapjump.contact.base import Approach, force_if_acting
from snapjump.damping.none import NoDamping
from snapjump.discretization.parts.loose_nodes import LooseNodes
from snapjump.ending.timed import TimedEnding
from snapjump.engine import clock as c
from snapjump.engine.model import Model
from snapjump.engine.status import NAMES, OK, REASONS
from snapjump.frame.parts.no_frame import NoFrame
from snapjump.load.inclined import InclinedGravity
from snapjump.recorder.trajectory import make_recorder
from snapjump.results import Result
from snapjump.scenes.runner import March, Progress
from snapjump.scenes.trajectory import trajectory_arrays
from snapjump.statics.resting_gap import resting_gap


def mass_model(simulation: Simulation, gravity_m_s2: float, incline: float) -> Model:
    """One loose node with the law's plain stiffness, gravity tilted by the incline."""
    scales = simulation.robot.scales
    angle = math.atan(incline)
    fall = gravity_m_s2 / scales.acceleration_m_s2
    return Model(
        LooseNodes(),
        NoFrame(),
        ConstantRate(0.0, 1.0, 1.0, 0.0),
        simulation.contact.law(scales),
        simulation.friction.law(scales, simulation.environment.mu),
        NoDamping.Law(),
        InclinedGravity(fall * math.cos(angle), fall * math.sin(angle)),
        simulation.contact.ground(scales, None),
    )


def beginning(
    model: Model, mass_bar: float, state: tuple[float, float], velocity: tuple[float, float]
) -> tuple[float, float]:
    """Acceleration (L/T^2) of the mass at its first moment."""
    approach = Approach(velocity[1], 0.0, state[1], velocity[1], 0.0)
    normal = float(force_if_acting(model.contact, state[1], approach)[1]) / mass_bar
    ratio = model.friction.ratio(velocity[0])
    return model.load.tangential - float(ratio) * normal, normal - model.load.normal


def march_mass(
    simulation: Simulation,
    model: Model,
    mass_bar: float,
    state: tuple[float, float],
    velocity: tuple[float, float],
    progress: Progress | None,
) -> tuple[Result, dict[str, Any]]:
    """Follow the mass for the scene's duration; returns the result and its arrays."""
    begun = time.perf_counter()
    scene, scales = simulation.sim, simulation.robot.scales
    duration = scene.duration_s / scales.time_s
    march = March(
        models=[model],
        masses=np.array([mass_bar]),
        states=np.array([state]),
        velocities=np.array([velocity]),
        accelerations=np.array([beginning(model, mass_bar, state, velocity)]),
        simulation=simulation,
        ending=TimedEnding(duration),
        recorder=make_recorder(2, duration, scene.sample_interval_s / scales.time_s),
    )
    outcome = march.run(progress)[0]
    arrays = trajectory_arrays(simulation, model, march)
    status = int(outcome[c.STATUS])
    summary: dict[str, Any] = {
        "status": NAMES[status],
        "min_gap_m": float(outcome[c.SMALLEST_GAP]) * scales.length_m,
        "steps": int(outcome[c.STEPS]),
        "newton_iterations": int(outcome[c.ITERATIONS]),
        "max_residual": float(outcome[c.LARGEST_RESIDUAL]),
        "accuracy": simulation.accuracy,
        "kernel_seconds": march.kernel_seconds,
        "wall_seconds": time.perf_counter() - begun,
    }
    message = "" if status == OK else REASONS[status]
    return Result(NAMES[status], message, summary, arrays, simulation), arrays


def simulate_bounce_scene(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Drop a mass into the barrier without gravity: a conservative bounce has restitution 1."""
    scene, scales = simulation.sim, simulation.robot.scales
    model = mass_model(simulation, 0.0, 0.0)
    mass = scene.mass_kg / scales.mass_kg
    start = (0.0, float(model.contact.reach()))
    fall = (0.0, -scene.speed_m_s / scales.velocity_m_s)
    result, arrays = march_mass(simulation, model, mass, start, fall, progress)
    speed = arrays["node_vy_m_s"][-1, 0]
    result.summary["rebound_speed_m_s"] = float(speed)
    result.summary["restitution"] = float(speed / scene.speed_m_s) if scene.speed_m_s else math.nan
    return result


def simulate_slide_scene(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Let a mass slide from its resting gap; smoothed Coulomb friction brings it to a creep."""
    scene, scales = simulation.sim, simulation.robot.scales
    model = mass_model(simulation, simulation.robot.gravity_m_s2, scene.incline)
    mass = scene.mass_kg / scales.mass_kg
    start = (0.0, resting_gap(model.contact, mass * model.load.normal, 1.0))
    velocity = (scene.speed_m_s / scales.velocity_m_s, 0.0)
    result, arrays = march_mass(simulation, model, mass, start, velocity, progress)
    result.summary["distance_m"] = float(arrays["node_x_m"][-1, 0])
    result.summary["final_speed_m_s"] = float(arrays["node_vx_m_s"][-1, 0])
    result.summary["resting_gap_m"] = start[1] * scales.length_m
    return result
