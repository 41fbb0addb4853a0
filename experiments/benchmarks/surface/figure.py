"""surface.png: the snap surface by collocation, points of ours on it, and their errors."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots.saving import panels

from ...styles import SERIES, boxes

SIZE = (11.5, 4.8)


def draw_surface(rows: Sequence[Row], elements: Sequence[int], path: Path) -> None:
    """A line for each pre-compression: the sum of both angles at the snap against their
    difference; and the largest error at every number of elements."""
    title = "The snap surface of the elastica (lines: collocation, marks: ours)"
    with panels(path, SIZE, title, *boxes(SIZE, 1, 2, left=0.8, across=1.0)) as (left, right):
        for epsilon, series in zip(sorted({row["epsilon"] for row in rows}), SERIES, strict=False):
            _draw(left, right, [r for r in rows if r["epsilon"] == epsilon], elements, series)
        left.set(xlabel="difference of the angles, Δα (rad)", ylabel="sum of the angles (rad)")
        left.set_ylim(0.0, None)
        left.legend(loc="lower left", ncols=2)
        right.set(xscale="log", yscale="log", xlabel="elements")
        right.set_ylabel("largest difference of the angle (%)")
        right.set_xticks(elements, [str(count) for count in elements])
        right.set_xticks([], minor=True)


def _draw(
    left: Any,
    right: Any,
    rows: Sequence[Row],
    elements: Sequence[int],
    series: tuple[str, str, Any],
) -> None:
    colour, mark, line = series
    lags, exact = column(rows, "delta_alpha_rad"), column(rows, "collocation_rad")
    finest = column(rows, str(elements[-1]))
    left.plot(lags, 2.0 * exact - lags, color=colour, lw=1.6, ls=line)
    left.plot(
        lags, 2.0 * finest - lags, mark, color=colour, ms=6, label=f"ε = {rows[0]['epsilon']:g}"
    )
    errors = [100.0 * np.abs(column(rows, str(n)) / exact - 1.0).max() for n in elements]
    right.plot(elements, errors, mark, color=colour, ms=6, lw=1.6, ls=line)
