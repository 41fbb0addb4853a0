"""Asymmetry of the snap by rate and imperfection, with turned clamps; the span's drive is named."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.scenes.swing import follow, outcome

from ...arches.swings import snap_groups, snap_of
from ...paper.base import listed
from ...paper.words import Words
from ...trends import power
from ..base import Compared, Source
from .figure import draw_tilts

EPSILON = 0.1
RATES_RAD_S = (2.0, 20.0, 200.0)
MISMATCHES_RAD = tuple(10.0**k for k in range(-7, -1))
# At which the rates are compared; and the rate, and the tilts (rad) up to which a tilt is small.
COMPARED_RAD, PROPORTIONAL_RAD_S, SMALL_RAD = 1e-4, 20.0, 0.05


def tilt_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each mismatch at one rate."""
    rate = inputs["rate_rad_s"]
    return [
        {
            "rate_rad_s": rate,
            "delta_alpha_rad": lag,
            **outcome(follow(snap_of(inputs["groups"], EPSILON, lag, rate))),
        }
        for lag in inputs["mismatches_rad"]
    ]


class Span(Source):
    """A cell for each rate."""

    name = "span"
    words = Words(__file__)
    kinds = {"tilts": tilt_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Tilts at every mismatch."""
        made = snap_groups(groups, "standard")
        return [
            Cell(
                f"{rate:g} rad per s",
                {"kind": "tilts", "groups": made, "rate_rad_s": rate,
                 "mismatches_rad": MISMATCHES_RAD},
            )
            for rate in RATES_RAD_S
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Two trends, and what a drive by the span would tell."""
        rows = [row for one in done.values() for row in one.rows]
        tilts = [tilt(rows, rate, COMPARED_RAD) for rate in RATES_RAD_S]
        ratio = tilts[0] / tilts[-1]
        small = [
            row
            for row in rows
            if row["rate_rad_s"] == PROPORTIONAL_RAD_S and (row["theta_max_rad"] or 1) < SMALL_RAD
        ]
        lags = column(small, "delta_alpha_rad")
        exponent = power(lags, column(small, "theta_max_rad")) if len(small) > 1 else np.nan
        comparisons = [
            self.compared(
                "rate", f"{tilts[0]:.3g} against {tilts[-1]:.3g}", f"{ratio:.3g} times",
                self.by_limit("rate", ratio), lag=COMPARED_RAD, slow=RATES_RAD_S[0],
                fast=RATES_RAD_S[-1], rates=listed(RATES_RAD_S), tilts=listed(tilts, ".3g"),
            ),
            self.compared(
                "proportional", f"{exponent:.4f}", f"{exponent - 1.0:+.4f}",
                self.by_limit("proportional", abs(exponent - 1.0)), rate=PROPORTIONAL_RAD_S,
                low=min(lags, default=np.nan), high=max(lags, default=np.nan),
            ),
            self.told("unloading", "no such drive"),
        ]  # fmt: skip
        shown = [
            {key: row[key] for key in ("rate_rad_s", "delta_alpha_rad", "theta_max_rad")}
            for row in rows
        ]
        section = self.section(
            comparisons, {"span": partial(draw_tilts, shown)}, {"span_tilts": shown},
            epsilon=EPSILON,
        )  # fmt: skip
        summary = {"span_tilt_ratio": ratio, "span_exponent": exponent}
        return Compared(section, [], summary, comparisons)


def tilt(rows: Sequence[Row], rate: float, lag: float) -> float:
    """The largest tilt at a rate and a mismatch; NaN if there was no snap."""
    places = {(row["rate_rad_s"], row["delta_alpha_rad"]): row["theta_max_rad"] for row in rows}
    found = places[rate, lag]
    return np.nan if found is None else float(found)
