"""Robots far from the paper's: one to three inputs moved, or designs from ranges twice as wide.

An input is moved log-uniformly by up to 10 times, every third robot's by up to 100; one that is 0
is drawn from its range.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from experiments.designs import AXES
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import Input, inputs_of, value_at, with_inputs
from snapjump.scenes.jump_start import mount_height_bar

MOST_MOVED = 3
FACTOR, FAR_FACTOR = 10.0, 100.0
FAR_EVERY = 3  # robots
LEAST = {"environment.mass_bar": 0.05}  # of ranges twice as wide that would reach below 0
MOST = {"design.epsilon": 0.4}

Moved = dict[str, float]


def moved_robots(base: Simulation, seed: int) -> Iterator[Moved | None]:
    """Draws without end: values of inputs by path, None where they make no robot."""
    rng = np.random.default_rng(seed)
    declared = inputs_of(base)
    for count in iter(lambda: rng.integers(1, MOST_MOVED + 1), 0):
        factor = FAR_FACTOR if rng.random() < 1.0 / FAR_EVERY else FACTOR
        chosen = rng.choice(list(declared), count, replace=False)
        values = {path: moved(base, declared[path], factor, rng) for path in chosen.tolist()}
        yield values if possible(base, values) else None


def moved(base: Simulation, one: Input, factor: float, rng: np.random.Generator) -> float:
    """Another value of an input, up to ``factor`` times larger or smaller."""
    here = value_at(base, one.path)
    if here == "optimal":
        here = mount_height_bar(base) * base.robot.length_m
    if here == 0.0:
        low, high = one.plan or (one.allowed.low, one.allowed.high)
        return float(rng.uniform(low, high)) * factor / FACTOR
    return float(here * factor ** rng.uniform(-1.0, 1.0))


def wide_designs(base: Simulation, seed: int) -> Iterator[Moved | None]:
    """Designs without end, evenly from ranges twice as wide as the paper's about their middle, of
    which at least one number lies beyond."""
    rng = np.random.default_rng(seed)
    while True:
        values = {}
        for axis in AXES:
            half = axis.high - axis.low
            low, high = 0.5 * (axis.low + axis.high) - half, 0.5 * (axis.low + axis.high) + half
            low = max(low, LEAST.get(axis.path, low if low < 0.0 else 0.0))
            values[axis.path] = float(rng.uniform(low, min(high, MOST.get(axis.path, high))))
        beyond = any(not axis.low <= values[axis.path] <= axis.high for axis in AXES)
        yield values if beyond and possible(base, values) else None


def possible(base: Simulation, values: Moved) -> bool:
    """Whether the values make a simulation."""
    try:
        with_inputs(base, values)
    except ParameterError:
        return False
    return True


def simulation_of(base: Simulation, values: Moved) -> Simulation:
    """The robot of a draw."""
    found: Any = with_inputs(base, values)
    return found
