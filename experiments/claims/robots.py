"""Robots far from the paper's: one to three inputs moved, or designs from ranges twice as wide.

An input is moved log-uniformly by up to 10 times, every third robot's by up to 100; one that is 0,
or not given, is drawn from its range.
"""

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import Input, inputs_of, value_at, with_inputs
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


def paper_designs(base: Simulation, seed: int) -> Draws:
    """Designs spread over the paper's ranges."""
    while True:
        for design in spread_designs(1024, seed):
            yield dict(zip((axis.path for axis in AXES), design, strict=True))
        seed += 1


def possible(base: Simulation, values: Values) -> Values | None:
    """The values, if they make a simulation."""
    try:
        with_inputs(base, values)
    except ParameterError:
        return None
    return values


KINDS: Mapping[str, Callable[[Simulation, int], Draws]] = {
    "inputs moved": moved_robots,
    "ranges twice as wide": wide_designs,
    "the paper's ranges": paper_designs,
}
