"""Snaps of arches whose clamps turn slowly: how far behind the fold the midpoint crosses."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.composition import Simulation
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap

from ...compositions import changed, composed

RISE = 2.0  # T, in which clamps reach their rate: so gently that undamped arches hardly swing
SAMPLES = 500  # that the scene keeps; the crossing is found between steps
AFTER = 20.0  # T, for the snap itself
LATEST = 8.0  # times the expected delay


def delay_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each rate (over sqrt(epsilon), 1/T): angles of the fold and the snap over
    sqrt(epsilon), and the delay between them. ``expected``: delay over the rate to its power."""
    return [delayed(inputs["groups"], rate, inputs) for rate in inputs["rates"]]


def delayed(groups: Mapping[str, Any], rate: float, inputs: Mapping[str, Any]) -> Row:
    """One of them."""
    made = composed(groups)
    root, unit_s = math.sqrt(made.design.epsilon), made.robot.scales.time_s
    fold = fold_rad(made) / root
    expected = inputs["prefactor"] * rate ** inputs["exponent"]
    duration_s = ((fold + LATEST * expected) / rate + RISE + AFTER) * unit_s
    scene = {"duration_s": duration_s, "sample_interval_s": duration_s / SAMPLES}
    turned = {"rate_rad_s": rate * root / unit_s, "rise_time_s": RISE * unit_s}
    found = simulate(composed(changed(groups, {"sim": scene, "drive": turned}))).summary
    snap = found["alpha_snap_rad"]
    return {
        "status": found["status"],
        "rate": rate,
        "rate_rad_s": turned["rate_rad_s"],
        "fold": fold,
        "snap": None if snap is None else snap / root,
        "delay": None if snap is None else snap / root - fold,
        "steps": found["steps"],
    }


def fold_rad(simulation: Simulation) -> float:
    """Angle at which the arch loses its stability, on the mesh of the simulation."""
    design = simulation.design
    snap = find_snap(
        simulation.robot, simulation.discretization, design.epsilon, design.delta_alpha
    )
    return snap.alpha_rad
