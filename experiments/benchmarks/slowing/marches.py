"""Arches let go at rest, their clamps held a little beyond the fold: how long until they snap."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.composition import Simulation
from snapjump.engine.clamp.constant_rate import ConstantRate
from snapjump.run.studies.base import Row
from snapjump.statics.critical import find_snap

from ...compositions import composed
from ..held_march import crossing_of

LATEST, AFTER = 3.0, 20.0  # times the expected time, and T


def time_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each distance of the clamps from the fold (over sqrt(epsilon)): the time (T) at
    which the midpoint crosses the line of the clamps. ``prefactor``, ``exponent``: of the time that
    is expected."""
    made = composed(inputs["groups"])
    rows = []
    for distance in inputs["distances"]:
        expected = inputs["prefactor"] * distance ** inputs["exponent"]
        status, crossing = held(made, distance, LATEST * expected + AFTER)
        rows.append({"status": status, "distance": distance, "time": crossing})
    return rows


def held(simulation: Simulation, distance: float, duration: float) -> tuple[str, float]:
    """How it ended, and when (T) the midpoint crossed, of an arch that has the shape of the fold
    when its clamps are turned further by the distance at once, and held."""
    design = simulation.design
    snap = find_snap(
        simulation.robot, simulation.discretization, design.epsilon, design.delta_alpha
    )
    left = snap.alpha_rad + distance * math.sqrt(design.epsilon)
    clamp = ConstantRate(start=left, end=left, rate=0.0, delta_alpha=design.delta_alpha)
    return crossing_of(simulation, clamp, snap.before.state, duration)
