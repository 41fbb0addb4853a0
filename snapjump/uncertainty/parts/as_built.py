"""A robot as it is built, of which one input is off: all else stays as it lies on the table.

Its mass stays in grams, its clamps' height and clear span in mm. As they are given, mass_bar would
follow the beam's stiffness, epsilon its length, and a mount height that is ``optimal`` both.
"""

from dataclasses import replace
from typing import cast

from snapjump.composition import Simulation
from snapjump.declare.inputs import inputs_of, value_at, with_inputs
from snapjump.frame.parts.frame_mass import FrameMass
from snapjump.frame.parts.mass_layout import measured
from snapjump.robot.environment import mass_bar
from snapjump.scenes.jump_start import mount_height_bar


def built(simulation: Simulation) -> Simulation:
    """The simulation with the clamps' height as a number. Raises ParameterError."""
    robot = simulation.robot
    if not isinstance(robot.mount_height, str):
        return simulation
    height_m = float(mount_height_bar(simulation)) * robot.length_m
    return replace(simulation, robot=robot.changed(mount_height=height_m))


def with_error(simulation: Simulation, path: str, value: float) -> Simulation:
    """A robot as it is built, but for one input. Raises ParameterError for a value out of range."""
    group, _, name = path.partition(".")
    values, robot = {path: value}, simulation.robot
    if group == "robot":
        other = replace(robot, **{name: value})
        kept = simulation.environment.mass_kg(robot)
        values["environment.mass_bar"] = mass_bar(kept, other)
        if other.length_m != robot.length_m:
            span_m = robot.length_m * (1.0 - simulation.design.epsilon)
            values["design.epsilon"] = 1.0 - span_m / other.length_m
    return with_inputs(simulation, values)


def nominal(simulation: Simulation, path: str) -> float | str:
    """The value of an input of a robot as built; that of a mass evenly along leg, top, leg where a
    frame's is not given. Why there is none, in words, where there is none."""
    if path not in inputs_of(simulation):
        group = path.partition(".")[0]
        return f"{group}={getattr(simulation, group).name} has none"
    value = value_at(simulation, path)
    if value is None and path in EVENLY:
        return evenly(simulation)[path]
    return "not given" if value is None else float(value)


EVENLY = ("frame.mass_centre_height_m", "frame.inertia_kg_m2")


def evenly(simulation: Simulation) -> dict[str, float]:
    """Height of the centre (m) and moment of inertia (kg m^2) of a rigid frame's own mass where
    that lies evenly along leg, top, leg."""
    robot, frame = simulation.robot, cast(FrameMass, simulation.frame)
    mass_kg = simulation.environment.mass_kg(robot) - robot.beam_mass_kg
    span_m = robot.length_m * (1.0 - simulation.design.epsilon)
    own_kg = mass_kg - 2.0 * frame.clamp_mass_kg
    lump = measured(own_kg, span_m, robot.frame_height_m, (0.0, None), None)
    return dict(zip(EVENLY, (lump.y, lump.inertia), strict=True))
