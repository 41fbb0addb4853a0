"""Cells of jumps: apexes of designs, and what is seen of each in time."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from experiments.compositions import composed
from experiments.paper.jumps import jump_rows
from experiments.paper.settings import BASELINE, NAMES
from snapjump.batch import variant
from snapjump.composition import Simulation
from snapjump.declare.members import member_class
from snapjump.results import Result
from snapjump.run.studies.base import Row
from snapjump.scenes import strike
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap

Design = tuple[float, ...]
# Between samples: of a strike, of the way up, and of the slow loading before the snap.
STRIKE_S, PATH_S, LOADING_S = 1e-5, 5e-5, 1e-4


def varied(name: str, values: Sequence[float], about: Design = BASELINE) -> list[Design]:
    """The baseline, or another design, with these values of one number."""
    place = NAMES.index(name)
    return [(*about[:place], float(value), *about[place + 1 :]) for value in values]


def followed(simulation: Simulation, interval_s: float) -> Result:
    """The jump with its trajectory."""
    scene = simulation.sim.changed(sample_interval_s=interval_s)
    scalar = member_class("backend", "scalar")()
    return simulate(replace(simulation, sim=scene, backend=scalar))


def jumps(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each of the cell's ``designs``."""
    return jump_rows(composed(inputs["groups"]), inputs["designs"])


def path(inputs: Mapping[str, Any]) -> list[Row]:
    """The way of the centre of mass of the only one of the cell's ``designs``."""
    (design,) = inputs["designs"]
    robot = variant(composed(inputs["groups"]), design)
    columns = strike.centre_of_mass(followed(robot, PATH_S))
    values = (one.tolist() for one in columns.values())
    return [dict(zip(columns, row, strict=True)) for row in zip(*values, strict=True)]


def sliding_row(robot: Simulation) -> Row:
    """Which way the beam slides."""
    return strike.sliding(followed(robot, STRIKE_S))


def energy_row(robot: Simulation) -> Row:
    """What the design's arch, mismatch and all, releases under slow loading (EI/L), and shares."""
    design = robot.design
    snap = find_snap(robot.robot, robot.discretization, design.epsilon, design.delta_alpha)
    released = snap.before.energy - snap.after.energy
    shares = strike.energy_shares(followed(robot, STRIKE_S), released)
    return {"energy_released_bar": released, **shares}


def each(look: Callable[[Simulation], Row], key: str) -> Callable[[Mapping[str, Any]], list[Row]]:
    """What computes a row for each of a cell's ``designs``: one of its numbers, and what a look
    tells."""

    def rows(inputs: Mapping[str, Any]) -> list[Row]:
        base, place = composed(inputs["groups"]), NAMES.index(key)
        return [{key: one[place], **look(variant(base, one))} for one in inputs["designs"]]

    return rows
