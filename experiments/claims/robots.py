"""Robots far from the paper's: one to three inputs moved, designs from ranges twice as wide, and
such designs as they are built: in air, their masses measured.

An input is moved log-uniformly by up to 10 times, every third robot's by up to 100; one that is 0,
or not given, is drawn from its range.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import Input, inputs_of, value_at, with_inputs
from snapjump.drag.quadratic import QuadraticDrag
from snapjump.robot.environment import mass_bar
from snapjump.scenes.jump_start import mount_height_bar

from ..designs import AXES, spread_designs

Values = dict[str, float]  # by path
Draws = Iterator[Values | None]  # without end; None where no robot can be made of them
MOST_MOVED = 3
FACTOR, FAR_FACTOR = 10.0, 100.0
FAR_SHARE = 1.0 / 3.0
LIGHTEST = 0.05  # mass_bar of ranges twice as wide, which would reach below 0


def moved_robots(base: Simulation, seed: int) -> Draws:
    """Robots of which one to three inputs are moved."""
    rng = np.random.default_rng(seed)
    declared = inputs_of(base)
    while True:
        count = int(rng.integers(1, MOST_MOVED + 1))
        factor = FAR_FACTOR if rng.random() < FAR_SHARE else FACTOR
        chosen = rng.choice(list(declared), count, replace=False).tolist()
        yield possible(base, {path: moved(base, declared[path], factor, rng) for path in chosen})


def moved(base: Simulation, one: Input, factor: float, rng: np.random.Generator) -> float:
    """Another value of an input, up to ``factor`` times larger or smaller."""
    here = value_at(base, one.path)
    if isinstance(here, str):
        here = mount_height_bar(base) * base.robot.length_m
    if here is None or here == 0.0:
        low, high = one.plan or (one.allowed.low, one.allowed.high)
        return float(rng.uniform(low, high) * factor / FACTOR)
    return float(here * factor ** rng.uniform(-1.0, 1.0))


def wide_designs(base: Simulation, seed: int) -> Draws:
    """Designs evenly from ranges twice as wide as the paper's about their middle, at least one
    number of each beyond those."""
    rng = np.random.default_rng(seed)
    while True:
        values = {}
        for axis in AXES:
            half, middle = axis.high - axis.low, 0.5 * (axis.low + axis.high)
            values[axis.path] = float(rng.uniform(middle - half, middle + half))
        values["environment.mass_bar"] = max(values["environment.mass_bar"], LIGHTEST)
        beyond = any(not axis.low <= values[axis.path] <= axis.high for axis in AXES)
        yield possible(base, values) if beyond else None


def as_built(base: Simulation, seed: int) -> Draws:
    """Designs from ranges twice as wide, with drag and a frame's mass over all that estimates know:
    where its centre is, its radius of gyration, and up to a fifth of the robot at each clamp."""
    rng, robot = np.random.default_rng(seed), base.robot
    for design in filter(None, wide_designs(base, seed)):
        half_m = 0.5 * robot.length_m * (1.0 - design["design.epsilon"])
        height_m = robot.frame_height_m
        whole_kg = design["environment.mass_bar"] / mass_bar(1.0, robot)
        clamp_kg = whole_kg * rng.uniform(0.0, 0.2)
        gyration_m = np.hypot(2.0 * half_m, height_m) * rng.uniform(0.12, 0.9)
        more = {
            "frame.mass_centre_height_m": height_m * rng.uniform(0.1, 1.5),
            "frame.mass_centre_offset_m": half_m * rng.uniform(-0.35, 0.35),
            "frame.inertia_kg_m2": (whole_kg - 2.0 * clamp_kg) * gyration_m**2,
            "frame.clamp_mass_kg": clamp_kg,
            "drag.coefficient": 10.0 ** rng.uniform(-0.5, 1.0),
            "drag.area_m2": 10.0 ** rng.uniform(-4.5, -1.5),
        }
        yield possible(base, design | {path: float(value) for path, value in more.items()})


def paper_designs(base: Simulation, seed: int) -> Draws:
    """Designs spread over the paper's ranges."""
    while True:
        for design in spread_designs(1024, seed):
            yield dict(zip((axis.path for axis in AXES), design, strict=True))
        seed += 1


def robot_of(base: Simulation, values: Values) -> Simulation:
    """The simulation of a robot: in air, if it has numbers of that. Raises ParameterError."""
    in_air = any(path.startswith("drag.") for path in values)
    return with_inputs(replace(base, drag=QuadraticDrag()) if in_air else base, values)


def possible(base: Simulation, values: Values) -> Values | None:
    """The values, if they make a simulation."""
    try:
        robot_of(base, values)
    except ParameterError:
        return None
    return values


KINDS: Mapping[str, Callable[[Simulation, int], Draws]] = {
    "inputs moved": moved_robots,
    "ranges twice as wide": wide_designs,
    "as built": as_built,
    "the paper's ranges": paper_designs,
}
