"""The largest angle of the midpoint against the mismatch, at three pre-compressions."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from experiments.paper.asymmetry.compute import sweep_rows
from experiments.paper.asymmetry.figure import draw_asymmetry
from experiments.paper.asymmetry.judge import (
    FITTED_UPTO_RAD,
    FLAT_FROM,
    LINEAR_WITHIN,
    Saturation,
    largest_difference,
    linear_statement,
    saturation,
    saturation_statement,
)
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.settings import RANGES, snap_groups
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

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


TITLE = "How asymmetric a snap becomes"
SHOWN = (0.01, 0.1, 0.2, 0.4)  # rad


def make_section(
    sweeps: Mapping[str, Mapping[float, Sequence[Row]]],
    found: Mapping[str, Mapping[float, Saturation]],
    upto_rad: float,
) -> Section:
    """Text, the figure, the laws and some of the snaps."""
    misfit = max(one.misfit for laws in found.values() for one in laws.values())
    own = found["standard"]
    far = max(one.threshold_rad for one in own.values())
    faster, freely = (
        [found[setting][epsilon].slope / own[epsilon].slope for epsilon in own]
        for setting in ("paper", "undamped")
    )
    lags = sorted(row["delta_alpha_rad"] for row in sweeps["standard"][min(own)])
    first = min(own)
    later, same = with_vibration(sweeps["standard"][first])
    return Section(
        TITLE,
        [
            "The same snaps at three pre-compressions and at mismatches from "
            f"{lags[0]:g} to {lags[-1]:g} rad. θ_max is the largest absolute tangent angle at the "
            "midpoint until the snap ends.",
            "The threshold is found by fitting θ_max = slope · Δα / √(1 + (Δα / threshold)²) to "
            f"all mismatches up to {FITTED_UPTO_RAD:g} rad, by logarithms: that is how the "
            "amplitude of an unstable mode with a cubic limit depends on where it started. No snap "
            f"is farther than {100.0 * misfit:.1f} % from it. For comparison the threshold is also "
            f"taken as θ_max at {FITTED_UPTO_RAD:g} rad over the mean slope of the smallest.",
            "Every design in the paper's range of mismatches, shaded, snaps beyond the threshold, "
            f"by a factor of {RANGES['delta_alpha_rad'][0] / far:.0f} at least. What the mismatch "
            "still changes there is the tilt at rest, and when the snap happens.",
            f"At the paper's settings the slope is {min(faster):.1f} to {max(faster):.1f} times "
            "that of the converged model, without damping "
            f"{min(freely):.1f} to {max(freely):.1f} times. Kelvin-Voigt damping resists bending "
            "as such, and so holds back the asymmetric mode whose net stiffness is lost. The "
            "damping of implicit Euler goes with the net stiffness: it stills vibrations, but does "
            "not slow down what buckles. How the slope depends on the rate of the clamps: the "
            "section on symmetric and asymmetric snaps.",
            "If the vibration after the snap is counted as well (`theta_later_rad`), the slope at "
            f"ε = {first:g} is {later:.0f} instead of {own[first].slope:.0f} and the angles from "
            f"{FITTED_UPTO_RAD:g} rad on {'are the same' if same else 'differ'}. Without damping "
            "the vibration goes on, and its largest angle depends on the finest detail.",
        ],
        figures={
            "asymmetry": Figure(
                "θ_max against the mismatch: left with the paper's range shaded, and dash-dotted "
                "what is left without the tilt at rest; right by logarithms, the law at standard "
                "drawn thin, its threshold marked on it",
                partial(draw_asymmetry, sweeps, found["standard"]),
            )
        },
        tables={
            "saturation": Table(
                "Slope, level and threshold of the law; how far it is linear (within "
                f"{100.0 * LINEAR_WITHIN:g} %); how the level rises from {FLAT_FROM:g} thresholds "
                f"to {upto_rad:g} rad",
                [
                    {"setting": setting, "epsilon": epsilon, **asdict(one)}
                    for setting, laws in found.items()
                    for epsilon, one in laws.items()
                ],
                digits=dict.fromkeys(Saturation.__dataclass_fields__, 3),
            ),
            "snap_sweep": Table(
                "Some of the snaps at standard",
                [
                    {"epsilon": epsilon, **row}
                    for epsilon, rows in sweeps["standard"].items()
                    for row in rows
                    if row["delta_alpha_rad"] in SHOWN
                ],
            ),
        },
    )


def with_vibration(rows: Sequence[Row]) -> tuple[float, bool]:
    """The slope of the smallest mismatch with the vibration after the snap, and whether that adds
    nothing to the angles of larger ones."""
    smallest = min(rows, key=lambda row: row["delta_alpha_rad"])
    large = [row for row in rows if row["delta_alpha_rad"] >= FITTED_UPTO_RAD]
    return (
        float(smallest["theta_later_rad"] / smallest["delta_alpha_rad"]),
        all(row["theta_later_rad"] == row["theta_max_rad"] for row in large),
    )
