"""Our snaps of the beam alone beside an independent solution's, which has no damping."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from snapjump.run.studies.base import Row
from snapjump.scenes.swing import Swing, crossing

DATA = Path(__file__).parents[1] / "data" / "galerkin_snaps.json"
# At which moments (T) heights are told, and how far the largest angle is taken.
MOMENTS_T, END_T = (2, 5), 8.42
QUANTITIES = (
    "crossing_T",
    "alpha_snap_rad",
    "midpoint_velocity_m_s",
    "tangent_crossing_rad",
    "tangent_until_rad",
    "height_rest_bar",
    "height_2T_bar",
    "height_5T_bar",
)


def exact_snaps() -> list[Row]:
    """The independent solution: a row for each mismatch and number of terms, the best last."""
    rows: list[Row] = json.loads(DATA.read_text())
    return sorted(rows, key=lambda row: (row["delta_alpha_rad"], row["terms"]))


def compared(swing: Swing) -> Row:
    """What the independent solution tells beside the crossing's angle and velocity."""
    time, tangent = swing.time_s / swing.unit_s, np.abs(swing.tangent_rad)
    row: Row = {
        "tangent_until_rad": float(tangent[time <= END_T].max()),
        "height_rest_bar": float(swing.height[0]),
    }
    for moment in MOMENTS_T:
        row[f"height_{moment}T_bar"] = float(np.interp(moment, time, swing.height))
    k = crossing(swing)
    if k is not None:
        about = slice(k - 1, k + 1)
        row["crossing_T"] = float(np.interp(0.0, -swing.height[about], time[about]))
        row["tangent_crossing_rad"] = float(np.interp(0.0, -swing.height[about], tangent[about]))
    return row


def agreement(settings: Mapping[str, Sequence[Row]], exact: Sequence[Row]) -> list[Row]:
    """How far snaps are from the independent solution's, in percent of its values.

    ``own_percent`` is how much that solution changes from its last number of terms but one.
    """
    table = []
    for lag in sorted({row["delta_alpha_rad"] for row in exact}):
        before, last = [row for row in exact if row["delta_alpha_rad"] == lag][-2:]
        ours = {name: row for name, rows in settings.items() for row in rows
                if row["delta_alpha_rad"] == lag}  # fmt: skip
        for key in QUANTITIES:
            if last[key] != 0.0:
                line: Row = {"delta_alpha_rad": lag, "quantity": key, "independent": last[key]}
                line["own_percent"] = 100.0 * abs(before[key] / last[key] - 1.0)
                for name, row in ours.items():
                    line[f"{name}_percent"] = 100.0 * (row[key] / last[key] - 1.0)
                table.append(line)
    return table


def largest_percent(table: Sequence[Row], name: str) -> float:
    """The largest entry of a column."""
    return max(abs(row[f"{name}_percent"]) for row in table)
