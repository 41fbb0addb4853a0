"""Verification: one mass on the ground, bouncing in the barrier or sliding to rest."""

import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.composition import Simulation
from snapjump.contact.base import ContactState, force_if_active
from snapjump.discretization.parts.loose_nodes import LooseNodes
from snapjump.engine.clamp.constant_rate import ConstantRate
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.model import Model
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.termination.timed import TimedTermination
from snapjump.frame.parts.no_frame import NoFrame
from snapjump.number.trigonometry import cos, sin
from snapjump.results import Result
from snapjump.scenes.march_outputs import GroundOutputs, RecordedOutputs, side_by_side
from snapjump.scenes.runner import March, Progress
from snapjump.scenes.trajectory import trajectory_arrays


def mass_model(simulation: Simulation, gravity_m_s2: float, slope_rad: float) -> Model:
    """One loose node with the law's plain stiffness, on ground that rises along +x."""
    scales = simulation.robot.scales
    fall = gravity_m_s2 / scales.acceleration_m_s2
    return Model(
        LooseNodes(),
        NoFrame(),
        ConstantRate(0.0, 1.0, 1.0, 0.0),
        contact=simulation.contact.law(scales),
        friction=simulation.friction.law(scales, simulation.environment.mu),
        load=Gravity(fall, cos(slope_rad), 0.0 - sin(slope_rad)),
        ground=simulation.contact.ground(scales, None),
    )


def beginning(
    model: Model, mass_bar: float, state: tuple[float, float], velocity: tuple[float, float]
) -> tuple[float, float]:
    """Acceleration (L/T^2) of the mass at its first moment."""
    resting = ContactState(velocity[1], 0.0, state[1], velocity[1], 0.0)
    normal = float(force_if_active(model.contact, state[1], resting)[1]) / mass_bar
    ratio = model.friction.ratio(velocity[0])
    return model.load.pull() - float(ratio) * normal, normal - model.load.gravity()


@dataclass(frozen=True)
class MassOutputs(GroundOutputs, RecordedOutputs):
    """Of a mass on the ground. ``arrays``: its trajectory."""

    arrays: dict[str, Any]


def march_mass(
    simulation: Simulation,
    model: Model,
    state: tuple[float, float],
    velocity: tuple[float, float],
    kind: type[MassOutputs],
    progress: Progress | None,
) -> Result:
    """Follow the mass for the scene's duration."""
    begun = time.perf_counter()
    scene, scales = simulation.sim, simulation.robot.scales
    duration = scene.duration_s / scales.time_s
    mass_bar = scene.mass_kg / scales.mass_kg
    march = March(
        models=[model],
        masses=np.array([mass_bar]),
        states=np.array([state]),
        velocities=np.array([velocity]),
        accelerations=np.array([beginning(model, mass_bar, state, velocity)]),
        simulation=simulation,
        termination=TimedTermination(duration),
        recorder=make_recorder(2, duration, scene.sample_interval_s / scales.time_s),
    )
    outcome = march.run(progress)
    arrays = trajectory_arrays(march, march.recorder)
    side = side_by_side([model])
    return kind(simulation, begun, side, outcome, march.kernel_seconds, arrays).result(arrays)
