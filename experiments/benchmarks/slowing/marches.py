"""Arches let go at rest, their clamps held a little beyond the fold: how long until they snap."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from snapjump.composition import Simulation
from snapjump.drive.hold_release import HoldRelease
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate

from ...compositions import composed
from ..delay.marches import SAMPLES

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
    time_s = simulation.robot.scales.time_s
    duration_s = duration * time_s
    found = simulate(
        replace(
            simulation,
            sim=simulation.sim.changed(
                duration_s=duration_s, sample_interval_s=duration_s / SAMPLES
            ),
            drive=HoldRelease(beyond_rad=distance * math.sqrt(simulation.design.epsilon)),
        )
    )
    crossed_s = found.summary["snap_time_s"]
    return found.status, math.nan if crossed_s is None else crossed_s / time_s
