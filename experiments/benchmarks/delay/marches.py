"""Snaps of arches that are driven slowly: how far behind the fold the midpoint crosses."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.composition import Simulation
from snapjump.results import Result
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap

from ...compositions import changed, composed
from ..symmetries.angles import one_end

RISE = 2.0  # T, in which drives reach their rate: so gently that undamped arches hardly swing
SAMPLES = 500  # that the scene keeps; the crossing is found between steps
AFTER = 20.0  # T, for the snap itself
LATEST = 8.0  # times the expected delay
BEGIN, END = 1.2, 0.5  # pre-compressions between which a span opens, over the fold's


def turned_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each rate of the left clamp (over sqrt(epsilon), 1/T): angles of the fold and the
    snap over sqrt(epsilon), and the delay between them. ``right_share``: rate of the right clamp
    over the left one's, 1, or 0 for one that is flat; ``prefactor``, ``exponent``: of the delay
    that is expected."""
    made = composed(inputs["groups"])
    root, unit_s = math.sqrt(made.design.epsilon), made.robot.scales.time_s
    fold = (fold_rad(made) if inputs["right_share"] else one_end(made, root * root)) / root
    rows = []
    for rate in inputs["rates"]:
        own = {"rate_rad_s": rate * root / unit_s}
        right = {"right_rate_rad_s": inputs["right_share"] * own["rate_rad_s"]}
        found = driven(inputs, {"name": "smooth_start", **own, **right}, rate, fold)
        snap = found.summary["alpha_snap_rad"]
        at = None if snap is None else snap / root
        delay = None if at is None else at - fold
        rows.append(row_of(found, {"rate": rate, **own, "fold": fold, "snap": at, "delay": delay}))
    return rows


def opened_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each rate of the span (over epsilon, 1/T), the clamps at the angle of the fold:
    pre-compressions of the fold and the snap over the fold's, and the delay between them."""
    made = composed(inputs["groups"])
    epsilon, scales = made.design.epsilon, made.robot.scales
    drive = {"name": "unload", "angle_rad": fold_rad(made), "end_epsilon": END * epsilon}
    wide = changed(inputs["groups"], {"design": {"epsilon": BEGIN * epsilon}})
    rows = []
    for rate in inputs["rates"]:
        own = {"rate_m_s": rate * epsilon * scales.velocity_m_s}
        found = driven({**inputs, "groups": wide}, {**drive, **own}, rate, BEGIN - 1.0)
        snap = snap_epsilon(found)
        at = None if snap is None else snap / epsilon
        delay = None if at is None else 1.0 - at
        rows.append(row_of(found, {"rate": rate, **own, "fold": 1.0, "snap": at, "delay": delay}))
    return rows


def driven(inputs: Mapping[str, Any], drive: Mapping[str, Any], rate: float, way: float) -> Result:
    """A snap at a rate (1/T), followed until far behind the way after which its fold is met."""
    unit_s = composed(inputs["groups"]).robot.scales.time_s
    late = LATEST * inputs["prefactor"] * rate ** inputs["exponent"]
    duration_s = ((way + late) / rate + RISE + AFTER) * unit_s
    changes = {
        "sim": {"duration_s": duration_s, "sample_interval_s": duration_s / SAMPLES},
        "drive": {**drive, "rise_time_s": RISE * unit_s},
    }
    return simulate(composed(changed(inputs["groups"], changes)))


def row_of(found: Result, row: Row) -> Row:
    """Between how the march ended and how many steps it took."""
    return {"status": found.status, **row, "steps": found.summary["steps"]}


def snap_epsilon(found: Result) -> float | None:
    """Pre-compression as the midpoint crosses the line of the clamps, of a span that opens."""
    snap_time_s, simulation = found.summary["snap_time_s"], found.simulation
    if snap_time_s is None:
        return None
    time = snap_time_s / simulation.robot.scales.time_s
    apart = simulation.drive.programme(simulation, 0.0).angles(time).apart
    return float(simulation.design.epsilon - apart)


def fold_rad(simulation: Simulation) -> float:
    """Angle at which the arch loses its stability, on the mesh of the simulation."""
    design = simulation.design
    snap = find_snap(
        simulation.robot, simulation.discretization, design.epsilon, design.delta_alpha
    )
    return snap.alpha_rad
