"""Snaps of arches whose span opens: how much they tilt, and at which pre-compression they come."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.optimize import brentq

from snapjump.composition import Simulation
from snapjump.run.studies.base import Row
from snapjump.scenes.swing import follow, outcome
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap

from ...compositions import changed, composed
from ..delay.marches import snap_epsilon
from ..surface.collocation import Clamps, fold

AFTERWARDS_S = 1e-2  # for the snap itself, and its end
RISE_S = 1e-3
BRACKET = (0.95, 1.05)  # of the elastica's fold, where that of a mesh is looked for


def opened(inputs: Mapping[str, Any], angle_rad: float, rate_m_s: float, lag: float) -> Simulation:
    """A span that opens from ``begin`` to ``end``, clamps held at an angle, the right one behind by
    ``lag``."""
    begin, end = inputs["begin"], inputs["end"]
    way_m = (begin - end) * composed(inputs["groups"]).robot.length_m
    duration_s = way_m / rate_m_s + RISE_S + AFTERWARDS_S
    changes = {
        "design": {"epsilon": begin, "delta_alpha": lag},
        "drive": {"name": "unload", "angle_rad": angle_rad, "rate_m_s": rate_m_s,
                  "end_epsilon": end, "rise_time_s": RISE_S},
        "sim": {"duration_s": duration_s},
    }  # fmt: skip
    return composed(changed(inputs["groups"], changes))


def tilt_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each mismatch at one rate."""
    rate = inputs["rate_m_s"]
    return [
        {
            "rate_m_s": rate,
            "delta_alpha_rad": lag,
            **outcome(follow(opened(inputs, inputs["angle_rad"], rate, lag))),
        }
        for lag in inputs["mismatches_rad"]
    ]


def fold_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each rate: ``snap``, the pre-compression at the snap; ``mesh``: where arches of
    these clamps have their fold on this mesh; ``fold``: where the elastica has it, whose angle by
    collocation the clamps are held at."""
    made, epsilon, lag = composed(inputs["groups"]), inputs["epsilon"], inputs["delta_alpha_rad"]
    stretch = 1.0 / made.robot.stretching_stiffness_bar
    angle = fold(Clamps(epsilon, lag, stretch)).left

    def beyond(own: float) -> float:
        return find_snap(made.robot, made.discretization, own, lag).alpha_rad - angle

    mesh = brentq(beyond, *(share * epsilon for share in BRACKET), xtol=1e-12)
    rows = []
    for rate in inputs["rates_m_s"]:
        found = simulate(opened(inputs, angle, rate, lag))
        snap = snap_epsilon(found)
        rows.append(
            {
                "status": found.status,
                "rate_m_s": rate,
                "snap": np.nan if snap is None else snap,
                "mesh": float(mesh),
                "fold": epsilon,
            }
        )
    return rows
