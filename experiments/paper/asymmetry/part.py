"""The largest angle of the midpoint against the mismatch, at three pre-compressions."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from experiments.paper.asymmetry.compute import sweep_rows
from experiments.paper.asymmetry.judge import (
    largest_difference,
    linear_statement,
    saturation_statement,
)
from experiments.paper.asymmetry.saturation import Saturation, saturation
from experiments.paper.asymmetry.section import TITLE, make_section
from experiments.paper.base import Found, Part
from experiments.paper.snap_settings import snap_groups
from experiments.paper.unfinished import unfinished
from snapjump.studies.base import Cell, Done, Row

EPSILONS = (0.1, 0.2, 0.3)
PLATEAU_UPTO_RAD = 0.2  # about the end of the paper's designs
LINEAR = tuple(round(0.01 * k, 3) for k in range(1, 21))
BEYOND = tuple(round(0.2 + 0.02 * k, 3) for k in range(1, 11))
FEW = (0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4)
SWEEPS = {"standard": 6, "paper": 3, "undamped": 2, "reference": 2}  # mismatches a decade


def mismatches(setting: str) -> list[float]:
    """From 1e-6 to 0.01 rad by equal factors, and on to 0.4 rad by equal steps."""
    count = 4 * SWEEPS[setting] + 1
    small = [float(f"{lag:.9e}") for lag in np.logspace(-6.0, -2.0, count)]
    return sorted({*small, *((*LINEAR, *BEYOND) if setting == "standard" else FEW)})


class Asymmetry(Part):
    """A sweep of the mismatch for each setting and pre-compression."""

    name = "asymmetry"
    sources = ("experiments.paper.asymmetry.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each sweep."""
        return [
            Cell(
                cell_name(setting, epsilon),
                {
                    "groups": snap_groups(groups, setting),
                    "epsilon": epsilon,
                    "mismatches_rad": mismatches(setting),
                },
            )
            for setting in SWEEPS
            for epsilon in EPSILONS
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The snaps of a sweep."""
        return sweep_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Two statements; none if a cell failed."""
        missing = unfinished(TITLE, done)
        if missing:
            return missing
        sweeps = {
            setting: {epsilon: done[cell_name(setting, epsilon)].rows for epsilon in EPSILONS}
            for setting in SWEEPS
        }
        found = {
            setting: {
                epsilon: saturation(rows, PLATEAU_UPTO_RAD) for epsilon, rows in by_epsilon.items()
            }
            for setting, by_epsilon in sweeps.items()
        }
        off = max(
            largest_difference(sweeps["standard"][epsilon], sweeps["reference"][epsilon])
            for epsilon in EPSILONS
        )
        accuracy = f"`standard` (angles within {100.0 * off:.1g} % of `reference`)"
        statements = [
            linear_statement(found, mismatches("standard")[0], accuracy),
            saturation_statement(found, PLATEAU_UPTO_RAD, accuracy),
        ]
        return Found(
            make_section(sweeps, found, PLATEAU_UPTO_RAD),
            statements,
            summary(found["standard"], off),
        )


def cell_name(setting: str, epsilon: float) -> str:
    """The cell of a sweep."""
    return f"{setting}, epsilon {epsilon:g}"


def summary(found: Mapping[float, Saturation], off: float) -> Row:
    """Flat numbers for result.json."""
    numbers: Row = {"asymmetry_off_reference_percent": 100.0 * off}
    for epsilon, one in found.items():
        key = f"{epsilon:g}".replace(".", "_")
        numbers |= {
            f"asymmetry_threshold_epsilon_{key}_rad": one.threshold_rad,
            f"asymmetry_level_epsilon_{key}_rad": one.level_rad,
            f"asymmetry_rise_epsilon_{key}": one.rise,
        }
    return numbers
