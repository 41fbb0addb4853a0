"""Cells: two snaps as motions, and the tilt of snaps with hardly any mismatch."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from experiments.paper.settings import snap_of
from snapjump.run.studies.base import Row
from snapjump.scenes.swing import Swing, crossing, follow, lowest, outcome

INSTANTS = 7  # shapes of a snap, between which the midpoint sinks by equal steps
BEFORE_MS, AFTER_MS = 4.0, 2.5  # of the crossing, what is kept of the midpoint's motion
REFERENCE_MOMENTS_T = (2, 5)
REFERENCE_END_T = 8.42  # how far the independent solution's largest angle is taken


def motion_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Of each mismatch a row of numbers, rows of shapes, and rows of the midpoint's motion."""
    rows = []
    for lag in inputs["delta_alpha_rad"]:
        swing = follow(snap_of(inputs["groups"], inputs["epsilon"], lag, inputs["rate_rad_s"]))
        found = [{"kind": "outcome", **outcome(swing), **compared(swing)}]
        k = crossing(swing)
        if k is not None:
            found += [*shapes(swing, lowest(swing, k)), *samples(swing, k)]
        rows += [{"delta_alpha_rad": lag, **row} for row in found]
    return rows


def compared(swing: Swing) -> Row:
    """What the independent solution tells beside the crossing's time, angle and velocity."""
    time, tangent = swing.time_s / swing.unit_s, np.abs(swing.tangent_rad)
    row: Row = {
        "tangent_until_rad": float(tangent[time <= REFERENCE_END_T].max()),
        "height_rest_bar": float(swing.height[0]),
    }
    for moment in REFERENCE_MOMENTS_T:
        row[f"height_{moment}T_bar"] = float(np.interp(moment, time, swing.height))
    k = crossing(swing)
    if k is not None:
        height = swing.height[k - 1 : k + 1]
        row["crossing_T"] = float(np.interp(0.0, -height, time[k - 1 : k + 1]))
        row["tangent_crossing_rad"] = float(np.interp(0.0, -height, tangent[k - 1 : k + 1]))
    return row


def shapes(swing: Swing, end: int) -> list[Row]:
    """The nodes at the instants, from rest to the midpoint's lowest place."""
    height = swing.height[: end + 1]
    levels = np.linspace(height[0], height[end], INSTANTS)
    chosen = [int(np.flatnonzero(height <= level)[0]) for level in levels]
    return [
        {
            "kind": "shape",
            "time_ms": 1e3 * float(swing.time_s[k]),
            "alpha_rad": swing.left_rad(float(swing.time_s[k])),
            "x_bar": swing.x[k].tolist(),
            "y_bar": swing.y[k].tolist(),
        }
        for k in chosen
    ]


def samples(swing: Swing, crossed: int) -> list[Row]:
    """The midpoint about the crossing."""
    time = 1e3 * (swing.time_s - swing.time_s[crossed])
    near = np.flatnonzero((time >= -BEFORE_MS) & (time <= AFTER_MS))
    height, tangent = swing.height, swing.tangent_rad
    return [
        {
            "kind": "sample",
            "time_ms": 1e3 * float(swing.time_s[k]),
            "height_bar": float(height[k]),
            "tangent_rad": float(tangent[k]),
        }
        for k in near
    ]


def imperfection_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each mismatch: :func:`experiments.paper.swing.outcome`."""
    epsilon, rate = inputs["epsilon"], inputs["rate_rad_s"]
    return [
        {
            "delta_alpha_rad": lag,
            **outcome(follow(snap_of(inputs["groups"], epsilon, lag, rate))),
        }
        for lag in inputs["imperfections_rad"]
    ]
