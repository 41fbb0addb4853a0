"""The largest angle of the midpoint against the mismatch, at three pre-compressions."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from experiments.arches.swings import snap_groups, snap_of
from experiments.paper.asymmetry import words
from experiments.paper.asymmetry.figure import draw_asymmetry
from experiments.paper.base import Found, Part, weakest
from experiments.paper.limits import LIMITS, judged
from experiments.trends import Saturation, saturation_of
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table, column
from snapjump.scenes.swing import follow, outcome

Array = Any
EPSILONS = (0.1, 0.2, 0.3)
PLATEAU_UPTO_RAD = 0.2  # about the end of the paper's designs
LINEAR = tuple(round(0.01 * k, 3) for k in range(1, 21))
BEYOND = tuple(round(0.2 + 0.02 * k, 3) for k in range(1, 11))
FEW = (0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4)
SWEEPS = {"standard": 6, "paper": 3, "undamped": 2, "reference": 2}  # mismatches a decade
# The law is of tilts that come from the instability alone; beyond 0.01 rad the tilt that the
# mismatch gives the arch at rest shows.
FITTED_UPTO_RAD = 0.01
FLAT_FROM = 10.0  # thresholds, from where on the level is looked at
SHOWN = (0.01, 0.1, 0.2, 0.4)  # rad


def mismatches(setting: str) -> list[float]:
    """From 1e-6 to 0.01 rad by equal factors, and on to 0.4 rad by equal steps."""
    count = 4 * SWEEPS[setting] + 1
    small = [float(f"{lag:.9e}") for lag in np.logspace(-6.0, -2.0, count)]
    return sorted({*small, *((*LINEAR, *BEYOND) if setting == "standard" else FEW)})


class Asymmetry(Part):
    """A sweep of the mismatch for each setting and pre-compression."""

    name = "asymmetry"
    title = words.TITLE

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each sweep."""
        at = {setting: snap_groups(groups, setting) for setting in SWEEPS}
        return [
            Cell(
                cell_name(name, epsilon),
                {"groups": made, "epsilon": epsilon, "mismatches_rad": mismatches(name)},
            )
            for name, made in at.items()
            for epsilon in EPSILONS
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """A snap for each mismatch (:func:`snapjump.scenes.swing.outcome`)."""
        groups, epsilon = inputs["groups"], inputs["epsilon"]
        return [
            {"delta_alpha_rad": lag, **outcome(follow(snap_of(groups, epsilon, lag)))}
            for lag in inputs["mismatches_rad"]
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Two statements."""
        sweeps = {
            setting: {epsilon: done[cell_name(setting, epsilon)].rows for epsilon in EPSILONS}
            for setting in SWEEPS
        }
        found = {
            setting: {epsilon: saturation(rows) for epsilon, rows in by_epsilon.items()}
            for setting, by_epsilon in sweeps.items()
        }
        own, laws = sweeps["standard"], found["standard"]
        off = max(largest_difference(own[e], sweeps["reference"][e]) for e in EPSILONS)
        summary: Row = {"asymmetry_off_reference_percent": 100.0 * off}
        for epsilon, one in laws.items():
            key = f"epsilon_{epsilon:g}".replace(".", "_")
            summary |= {
                f"asymmetry_threshold_{key}_rad": one.threshold_rad,
                f"asymmetry_level_{key}_rad": one.level_rad,
                f"asymmetry_rise_{key}": one.rise,
            }
        figure = partial(draw_asymmetry, sweeps, laws, FITTED_UPTO_RAD)
        rows = [
            {"setting": setting, "epsilon": epsilon, **asdict(one)}
            for setting, by_epsilon in found.items()
            for epsilon, one in by_epsilon.items()
        ]
        some = [
            {"epsilon": epsilon, **row}
            for epsilon in EPSILONS
            for row in own[epsilon]
            if row["delta_alpha_rad"] in SHOWN
        ]
        range_of_level = FLAT_FROM, PLATEAU_UPTO_RAD
        digits = dict.fromkeys(Saturation.__dataclass_fields__, 3)
        tables = {
            "saturation": Table(words.laws(*range_of_level), rows, digits),
            "snap_sweep": Table("Some of the snaps at standard", some),
        }
        line, level = linear_verdict(laws, mismatches("standard")[0]), saturation_verdict(laws)
        accuracy = f"`standard` (angles within {100.0 * off:.1g} % of `reference`)"
        return Found(
            Section(
                words.TITLE,
                words.told(found, own, FITTED_UPTO_RAD),
                {"asymmetry": Figure(words.FIGURE, figure)},
                tables,
            ),
            [
                words.linear(found, accuracy).judged("asymmetry.linear", line),
                words.saturates(found, *range_of_level, accuracy).judged(
                    "asymmetry.saturation", level
                ),
            ],
            summary,
        )


def cell_name(setting: str, epsilon: float) -> str:
    """The cell of a sweep."""
    return f"{setting}, epsilon {epsilon:g}"


def saturation(rows: Sequence[Row]) -> Saturation:
    """What the tilts of a sweep come to."""
    snapped = [r for r in rows if r["theta_max_rad"] is not None and r["delta_alpha_rad"] > 0.0]
    snapped = sorted(snapped, key=lambda row: row["delta_alpha_rad"])
    lags, tilts, rest = (
        column(snapped, key) for key in ("delta_alpha_rad", "theta_max_rad", "theta_rest_rad")
    )
    deviation = LIMITS["asymmetry.linear.deviation"].confirmed
    return saturation_of(
        lags, tilts, rest, FITTED_UPTO_RAD, (FLAT_FROM, PLATEAU_UPTO_RAD), deviation
    )


def linear_verdict(found: Mapping[float, Saturation], smallest_rad: float) -> str:
    """Linear up to mismatches that robots are designed with, or up to smaller ones only."""
    until = [one.linear_until_rad for one in found.values()]
    return weakest(
        judged("asymmetry.linear.exponent", *(abs(one.exponent - 1.0) for one in found.values())),
        judged("asymmetry.linear.range", *(one / smallest_rad for one in until)),
        judged("asymmetry.linear.designs", *until),
    )


def saturation_verdict(found: Mapping[float, Saturation]) -> str:
    """A plateau, or a growth that has at least broken off."""
    return judged("asymmetry.saturation", *(abs(one.rise) for one in found.values()))


def largest_difference(rows: Sequence[Row], truth: Sequence[Row]) -> float:
    """Largest relative difference of the tilts at mismatches that both have."""
    known = {row["delta_alpha_rad"]: row["theta_max_rad"] for row in truth}
    pairs = [(row["theta_max_rad"], known.get(row["delta_alpha_rad"])) for row in rows]
    return max((abs(own / right - 1.0) for own, right in pairs if own and right), default=math.nan)
