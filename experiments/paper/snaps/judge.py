"""What the symmetry of a snap depends on, and the verdict."""

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from experiments.paper.settings import RATE_RAD_S
from experiments.paper.statement import Statement, verdict
from snapjump.run.studies.base import Row

EPSILON, MISMATCH = 0.1, 0.1  # the paper's; the mismatch in rad


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


COMMAND = "task=paper figure=snaps"
VISIBLE_RAD = math.radians(1.0)  # a tilt of the midpoint that one sees
# With equal clamps the tilt is nothing but rounding, which is this much less than a real one.
NOTHING = 1e-6
# A tenth of a degree: about the best that two clamps are set equal. A symmetry that a smaller
# mismatch breaks is one of the simulation.
SET_BY_HAND_RAD = math.radians(0.1)


def tilt(rows: Sequence[Row], delta_alpha: float) -> float:
    """The largest tilt of the midpoint at a mismatch; NaN if there is no such snap."""
    found = [row["theta_max_rad"] for row in rows if row["delta_alpha_rad"] == delta_alpha]
    return float(found[0]) if found and found[0] is not None else math.nan


def symmetric_until(rows: Sequence[Row]) -> float:
    """The mismatch (rad) at which the tilt becomes visible; 0 if it is with equal clamps, infinity
    if it is with none of these."""
    snapped = [row for row in rows if row["theta_max_rad"] is not None]
    lags = np.array([row["delta_alpha_rad"] for row in snapped])
    tilts = np.array([row["theta_max_rad"] for row in snapped])
    order = np.argsort(lags)
    lags, tilts = lags[order], tilts[order]
    seen = np.flatnonzero(tilts >= VISIBLE_RAD)
    if len(seen) == 0:
        return math.inf
    k = int(seen[0])
    if k == 0 or lags[k - 1] == 0.0:
        # The tilt is proportional to so small a mismatch.
        return 0.0 if lags[k] == 0.0 else float(lags[k] * VISIBLE_RAD / tilts[k])
    return float(np.exp(np.interp(np.log(VISIBLE_RAD), np.log(tilts[k - 1 : k + 1]),
                                  np.log(lags[k - 1 : k + 1]))))  # fmt: skip


def symmetry_verdict(equal: float, mismatched: float, limits: Sequence[float]) -> str:
    """``equal``, ``mismatched``: tilts (rad) with equal clamps and with the paper's mismatch;
    ``limits``: :func:`symmetric_until` of the snaps at several rates."""
    holds = mismatched >= VISIBLE_RAD and equal <= NOTHING * mismatched
    return verdict(holds and min(limits) >= SET_BY_HAND_RAD, holds)


def symmetry_statement(
    motions: Mapping[str, Sequence[Row]], by_rate: Mapping[float, Sequence[Row]], lag: float
) -> Statement:
    """``motions``: numbers of the two snaps by setting, ``by_rate``: snaps at standard."""
    rows = motions["standard"]
    symmetric, tilted = ([row for row in rows if row["delta_alpha_rad"] == d][0] for d in (0, lag))
    equal, mismatched = tilt(rows, 0.0), tilt(rows, lag)
    limits = {rate: symmetric_until(found) for rate, found in by_rate.items()}
    told = "; ".join(limit_in_words(rate, limits[rate], by_rate[rate]) for rate in sorted(limits))
    others = ", ".join(
        f"{tilt(motions[name], lag):.3f} rad {words}"
        for name, words in (
            ("reference", "at `reference`"),
            ("paper", "at the paper's settings"),
            ("undamped", "without damping"),
        )
    )
    return Statement(
        "With equal clamps the beam snaps symmetrically, with a mismatch asymmetrically",
        symmetry_verdict(equal, mismatched, list(limits.values())),
        f"At {RATE_RAD_S:g} rad/s and ε = {EPSILON:g} the midpoint tilts by {equal:.1g} rad with "
        f"equal clamps and by {mismatched:.3f} rad ({math.degrees(mismatched):.0f}°) at "
        f"Δα = {lag:g} rad ({others}); it crosses the clamps' line at "
        f"α = {symmetric['alpha_snap_rad']:.3f} and {tilted['alpha_snap_rad']:.3f} rad, and "
        f"the snap takes {symmetric['snap_duration_ms']:.1f} and {tilted['snap_duration_ms']:.1f} "
        "ms. How nearly equal the clamps have to be depends on how fast they turn: a tilt of "
        f"{math.degrees(VISIBLE_RAD):g}° takes {told}",
        accuracy(motions, lag),
        COMMAND,
    )


def limit_in_words(rate: float, limit: float, rows: Sequence[Row]) -> str:
    """At which mismatch the tilt is seen when the clamps turn at this rate (rad/s)."""
    if limit == 0.0:
        return f"no mismatch at all at {rate:g} rad/s ({tilt(rows, 0.0):.2g} rad from rounding)"
    if math.isinf(limit):
        return f"more than was tried at {rate:g} rad/s"
    return f"a mismatch of {limit:.2g} rad at {rate:g} rad/s"


def accuracy(motions: Mapping[str, Sequence[Row]], lag: float) -> str:
    """How far the tilt at standard is from that at reference."""
    truth = tilt(motions["reference"], lag)
    off = 100.0 * abs(tilt(motions["standard"], lag) / truth - 1.0)
    return f"`standard` ({off:.1g} % from `reference`)"
