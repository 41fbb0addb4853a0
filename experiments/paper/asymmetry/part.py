"""The largest angle of the midpoint against the mismatch, at three pre-compressions."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.scenes.swing import follow, outcome

from ...arches.swings import snap_groups, snap_of
from ...trends import Saturation, saturation_of
from ..base import Found, Part, listed, span, weakest
from ..limits import LIMITS, judged
from ..settings import RANGES
from ..words import Words
from .figure import draw_asymmetry

WORDS = Words(__file__)
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
SMALLEST_DESIGN_RAD = RANGES["delta_alpha_rad"][0]
# Numbers of a law, for reading.
READ: dict[str, Callable[[float], str]] = {
    "slope": lambda value: f"{float(f'{value:.2g}'):.0f}",  # two digits, without an exponent
    "threshold_rad": "{:.2g}".format,
    "level_rad": "{:.2f}".format,
    "linear_until_rad": "{:.2g}".format,
    "rise": lambda share: f"{100.0 * share:.0f}",
    "rise_untilted": lambda share: f"{100.0 * share:.1g}",
}


def mismatches(setting: str) -> list[float]:
    """From 1e-6 to 0.01 rad by equal factors, and on to 0.4 rad by equal steps."""
    count = 4 * SWEEPS[setting] + 1
    small = [float(f"{lag:.9e}") for lag in np.logspace(-6.0, -2.0, count)]
    return sorted({*small, *((*LINEAR, *BEYOND) if setting == "standard" else FEW)})


class Asymmetry(Part):
    """A sweep of the mismatch for each setting and pre-compression."""

    name = "asymmetry"
    title = "How asymmetric a snap becomes"

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
        digits = {"saturation": dict.fromkeys(Saturation.__dataclass_fields__, 3)}
        figures = {"asymmetry": partial(draw_asymmetry, sweeps, laws, FITTED_UPTO_RAD)}
        tables = {"saturation": rows, "snap_sweep": some}
        line, level = linear_verdict(laws, mismatches("standard")[0]), saturation_verdict(laws)
        values = told(found, own) | {"off_percent": 100.0 * off}
        return Found(
            WORDS.section(self.title, figures, tables, digits, **values),
            [
                WORDS.statement("linear", line, **values),
                WORDS.statement("saturation", level, **values),
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


def told(
    found: Mapping[str, Mapping[float, Saturation]], sweeps: Mapping[float, Sequence[Row]]
) -> dict[str, Any]:
    """What the words say; ``found``: laws by setting and pre-compression; ``sweeps``: at standard,
    of which the smallest pre-compression shows what the vibration after the snap adds."""
    own = found["standard"]
    first = min(own)
    rows = sorted(sweeps[first], key=lambda row: row["delta_alpha_rad"])
    low, high = (rows[k]["delta_alpha_rad"] for k in (0, -1))
    large = [row for row in rows if row["delta_alpha_rad"] >= FITTED_UPTO_RAD]
    same = all(row["theta_later_rad"] == row["theta_max_rad"] for row in large)
    until = [one.linear_until_rad for one in own.values()]
    twice = [abs(one.other_threshold_rad / one.threshold_rad - 1.0) for one in own.values()]
    faster, freely = (
        [found[setting][epsilon].slope / own[epsilon].slope for epsilon in own]
        for setting in ("paper", "undamped")
    )
    return {
        **{name: read(laws) for name, laws in found.items()},
        "epsilons": listed(own),
        "linear_percent": 100.0 * LIMITS["asymmetry.linear.deviation"].confirmed,
        "flat_from": FLAT_FROM,
        "plateau_upto_rad": PLATEAU_UPTO_RAD,
        "fitted_upto_rad": FITTED_UPTO_RAD,
        "most_deg": math.degrees(max(until)),
        "smallest_rad": SMALLEST_DESIGN_RAD,
        "smaller_by": (SMALLEST_DESIGN_RAD / max(until), SMALLEST_DESIGN_RAD / min(until)),
        "other_percent": 100.0 * max(twice),
        "low": low,
        "high": high,
        "misfit_percent": 100.0 * max(o.misfit for laws in found.values() for o in laws.values()),
        "beyond": SMALLEST_DESIGN_RAD / max(one.threshold_rad for one in own.values()),
        "faster": span(faster),
        "freely": span(freely),
        "first": first,
        "later": rows[0]["theta_later_rad"] / low,
        "slope": own[first].slope,
        "same": "are the same" if same else "differ",
    }


def read(laws: Mapping[float, Saturation]) -> dict[str, str]:
    """Numbers of laws at every pre-compression."""
    return {
        key: ", ".join(how(getattr(one, key)) for one in laws.values()) for key, how in READ.items()
    }
