"""Verification: one mass on the ground, bouncing in the barrier or sliding to rest."""

import time
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from snapjump.composition import Simulation
from snapjump.contact.base import ContactState, force_if_active
from snapjump.discretization.parts.loose_nodes import LooseNodes
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.model import Model
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.termination.one_mass import OneMassTermination
from snapjump.frame.parts.no_frame import NoFrame
from snapjump.number.trigonometry import cos, sin
from snapjump.results import Result
from snapjump.scenes.march_outputs import GroundOutputs, RecordedOutputs, side_by_side
from snapjump.scenes.mass_units import stick_speed
from snapjump.scenes.runner import March, Progress
from snapjump.scenes.trajectory import samples_of, trajectory_arrays
from snapjump.units import Scales

# Below the steps that the smallest gaps take whose powers are numbers, of e^-200 and less.
SMALLEST_STEP_BAR = 1e-150
FEWEST_STEPS = 500  # that a trajectory can be seen by
# Errors of a speed that Newton's method may leave: in its unit, and of the speed of sticking.
NEGLIGIBLE_SPEED = 1e-6
NEGLIGIBLE_SHARE = 0.03


def mass_model(
    simulation: Simulation, gravity_m_s2: float, slope_rad: float, units: Scales | None = None
) -> Model:
    """One loose node with the law's plain stiffness, on ground that rises along +x.
    In the robot's units, or in others."""
    scales = units or simulation.robot.scales
    fall = gravity_m_s2 / scales.acceleration_m_s2
    return Model(
        LooseNodes(),
        NoFrame(),
        ConstantRate.Law(0.0, 1.0, 1.0, 0.0),
        contact=simulation.contact.law(scales),
        friction=simulation.friction.law(scales, simulation.environment.mu),
        damping=simulation.damping.law(scales),
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
    along, up = (-model.damping.drag() * speed for speed in velocity)
    return (along + model.load.pull() - float(ratio) * normal, up + normal - model.load.gravity())


@dataclass(frozen=True)
class MassOutputs(GroundOutputs, RecordedOutputs):
    """Of a mass on the ground. ``units``: of the model's numbers."""

    units: Scales

    @cached_property
    def scales(self) -> Scales:
        return self.units


def march_mass(
    simulation: Simulation,
    model: Model,
    state: tuple[float, float],
    velocity: tuple[float, float],
    kind: type[MassOutputs],
    progress: Progress | None,
    units: Scales | None = None,
) -> Result:
    """Follow the mass for the scene's duration.

    Model, state (L) and velocity (L/T) are in the robot's units, or in others that are the
    motion's own: tolerances are then shares of what the scene is about, whatever its size.
    """
    begun = time.perf_counter()
    scene, scales = simulation.sim, units or simulation.robot.scales
    duration = scene.duration_s / scales.time_s
    mass_bar = scene.mass_kg / scales.mass_kg
    stick = stick_speed(model.friction)
    negligible = min(NEGLIGIBLE_SPEED, NEGLIGIBLE_SHARE * stick or NEGLIGIBLE_SPEED)
    march = March(
        models=[model],
        masses=np.array([mass_bar]),
        states=np.array([state]),
        velocities=np.array([velocity]),
        accelerations=np.array([beginning(model, mass_bar, state, velocity)]),
        simulation=simulation,
        termination=OneMassTermination(duration, negligible),
        recorder=make_recorder(2, duration, scene.sample_interval_s / scales.time_s),
        units=scales,
    )
    largest = largest_step(model, stick, duration)
    march.stepping = march.stepping.within(SMALLEST_STEP_BAR, largest)
    outcome = march.run(progress)
    arrays = trajectory_arrays(march, samples_of(march, march.recorder))
    side = side_by_side([model])
    outputs = kind(simulation, begun, side, outcome, march.kernel_seconds, arrays, scales)
    return outputs.result(arrays)


def largest_step(model: Model, stick: float, duration: float) -> float:
    """The largest step (T): in it lagged friction may change a speed by that of sticking."""
    largest = duration / FEWEST_STEPS
    if model.friction.is_lagged():
        brake = float(model.friction.ratio(1.0)) * model.load.gravity()
        if brake * largest > stick:
            return stick / brake
    return largest
