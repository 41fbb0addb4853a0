"""Asymmetry of the snap by the rate at which the span opens and by imperfection; and its fold."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column

from ...arches.swings import snap_groups
from ...paper.base import listed
from ...paper.words import Words
from ...trends import power, straight_line
from ..amplitude import DELAY_EXPONENTS
from ..arches import INERTIA
from ..base import Compared, Comparison, Number, Source, percent_off
from .figure import draw_tilts
from .marches import fold_rows, tilt_rows

ANGLE_RAD = 0.6
# From well above the fold (0.088) to where the snapped arch hardly carries thrust (alpha^2 / 6).
BEGIN, END = 0.2, 0.06
RATES_M_S = (0.01, 0.1, 1.0)
MISMATCHES_RAD = tuple(10.0**k for k in range(-7, -1))
# At which the rates are compared; and the rate, and the tilts (rad) up to which a tilt is small.
COMPARED_RAD, PROPORTIONAL_M_S, SMALL_RAD = 1e-4, 0.1, 0.05
# Of the fold: far from the pitchfork by its mismatch, and from which pre-compression on.
FOLD, FOLD_RAD, FOLD_BEGIN = 0.1, 0.1, 0.12
SLOW_M_S = (1e-2, 3e-3, 1e-3)
SLOW = "fold"


class Span(Source):
    """A cell for each rate, and one of the fold."""

    name = "span"
    words = Words(__file__)
    kinds = {"tilts": tilt_rows, "fold": fold_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Tilts at every mismatch."""
        made = snap_groups(groups, "standard")
        return [
            *(
                Cell(
                    f"{rate:g} m per s",
                    {"kind": "tilts", "groups": made, "rate_m_s": rate, "angle_rad": ANGLE_RAD,
                     "mismatches_rad": MISMATCHES_RAD, "begin": BEGIN, "end": END},
                )
                for rate in RATES_M_S
            ),
            Cell(
                SLOW,
                {"kind": "fold", "groups": made, "epsilon": FOLD, "delta_alpha_rad": FOLD_RAD,
                 "rates_m_s": SLOW_M_S, "begin": FOLD_BEGIN, "end": END},
            ),
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Two trends, and the fold."""
        rows = [row for name, one in done.items() if name != SLOW for row in one.rows]
        tilts = [tilt(rows, rate, COMPARED_RAD) for rate in RATES_M_S]
        ratio = tilts[0] / tilts[-1]
        small = [
            row
            for row in rows
            if row["rate_m_s"] == PROPORTIONAL_M_S and (row["theta_max_rad"] or 1) < SMALL_RAD
        ]
        lags = column(small, "delta_alpha_rad")
        exponent = power(lags, column(small, "theta_max_rad")) if len(small) > 1 else np.nan
        slow = done[SLOW].rows
        comparisons = [
            self.compared(
                "rate", f"{tilts[0]:.3g} against {tilts[-1]:.3g}", f"{ratio:.3g} times",
                self.by_limit("rate", ratio), lag=COMPARED_RAD, slow=RATES_M_S[0],
                fast=RATES_M_S[-1], rates=listed(RATES_M_S), tilts=listed(tilts, ".3g"),
            ),
            self.compared(
                "proportional", f"{exponent:.4f}", f"{exponent - 1.0:+.4f}",
                self.by_limit("proportional", abs(exponent - 1.0)), rate=PROPORTIONAL_M_S,
                low=min(lags, default=np.nan), high=max(lags, default=np.nan),
            ),
            self.fold(slow),
            self.told("unloading", listed(tilts, ".3g"), rates=listed(RATES_M_S), lag=COMPARED_RAD),
        ]  # fmt: skip
        shown = [
            {key: row[key] for key in ("rate_m_s", "delta_alpha_rad", "theta_max_rad")}
            for row in rows
        ]
        section = self.section(
            comparisons, {"span": partial(draw_tilts, shown)},
            {"span_tilts": shown, "span_fold": slow}, {"span_fold": {"snap": 6, "mesh": 6}},
            angle=ANGLE_RAD, begin=BEGIN, end=END, lag=FOLD_RAD, wide=FOLD_BEGIN,
        )  # fmt: skip
        summary = {"span_tilt_ratio": ratio, "span_exponent": exponent,
                   "span_fold_epsilon": at_rest(slow)}  # fmt: skip
        return Compared(section, [], summary, comparisons)

    def fold(self, rows: Sequence[Row]) -> Comparison:
        """The row of the fold."""
        ours, theirs, mesh = at_rest(rows), rows[0]["fold"], rows[0]["mesh"]
        off, off_mesh = percent_off(ours, theirs), percent_off(ours, mesh)
        return self.compared(
            "fold", f"{ours:.6f}", f"{off:.2g} %",
            self.weakest_of(("fold", off), ("mesh", off_mesh)),
            Number(theirs, self.words("fold: place")), rates=listed(SLOW_M_S), mesh=mesh,
            percent=off_mesh, agrees=self.by_limit("mesh", off_mesh), lag=FOLD_RAD,
        )  # fmt: skip


def tilt(rows: Sequence[Row], rate: float, lag: float) -> float:
    """The largest tilt at a rate and a mismatch; NaN if there was no snap."""
    places = {(row["rate_m_s"], row["delta_alpha_rad"]): row["theta_max_rad"] for row in rows}
    found = places[rate, lag]
    return np.nan if found is None else float(found)


def at_rest(rows: Sequence[Row]) -> float:
    """The pre-compression at the snap of a span that opens infinitely slowly: the delay is a power
    of the rate."""
    delays = column(rows, "rate_m_s") ** DELAY_EXPONENTS[INERTIA]
    return straight_line(delays, column(rows, "snap")).intercept
