"""The snaps beside the independent solution's."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from snapjump.studies.base import Row

EXACT = Path(__file__).parents[2] / "data" / "galerkin_snaps.json"
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
    """The independent solution: a row for each mismatch and number of terms."""
    rows: list[Row] = json.loads(EXACT.read_text())
    return rows


def agreement(settings: Mapping[str, Sequence[Row]], exact: Sequence[Row]) -> list[Row]:
    """How far the snaps are from the independent solution's, in percent of its values.

    ``own_percent`` is how much that solution changes from its last number of terms but one.
    """
    table = []
    finest: dict[float, tuple[Row, Row]] = {}
    for row in sorted(exact, key=lambda one: one["terms"]):
        before = finest.get(row["delta_alpha_rad"], (row, row))[1]
        finest[row["delta_alpha_rad"]] = (before, row)
    for lag, (before, last) in finest.items():
        for key in QUANTITIES:
            if last[key] == 0.0:
                continue
            line: Row = {
                "delta_alpha_rad": lag,
                "quantity": key,
                "independent": last[key],
                "own_percent": 100.0 * abs(before[key] / last[key] - 1.0),
            }
            for name, rows in settings.items():
                (one,) = [r for r in rows if r["delta_alpha_rad"] == lag]
                line[f"{name}_percent"] = 100.0 * (one[key] / last[key] - 1.0)
            table.append(line)
    return table


def largest_percent(table: Sequence[Row], name: str) -> float:
    """The largest entry of a column."""
    return max(abs(row[f"{name}_percent"]) for row in table)
