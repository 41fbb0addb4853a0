"""How figures show tiers and series, and where their panels stand."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from snapjump.show.plots import palette

DASHES: Any = (0, (5, 2.5))
DOTS: Any = (0, (1.2, 1.4))
# A colour, a marker and a line for each of several parameters, robots or grounds.
SERIES: tuple[tuple[str, str, Any], ...] = (
    (palette.BEAM, "o", "-"),
    (palette.FORCE, "s", (0, (6, 1.5))),
    (palette.CENTRE, "^", (0, (6, 1.5, 1, 1.5))),
    (palette.PLUM, "D", (0, (1.5, 1.5))),
    (palette.CLAMP, "v", DASHES),
)
PAPER = "the paper's settings"
TIERS: dict[str, dict[str, Any]] = {
    "standard": {"color": palette.BEAM, "lw": 2.2, "label": "standard"},
    "paper": {"color": palette.FORCE, "lw": 1.4, "ls": DASHES, "label": PAPER},
    "paper, short step": {"color": palette.CENTRE, "lw": 1.3, "ls": DOTS,
                          "label": "the same with a tenth of its step"},
    "reference": {"color": palette.INK, "ls": "", "marker": "o", "ms": 4.2, "mfc": "none",
                  "label": "reference"},
}  # fmt: skip
Box = tuple[float, float, float, float]


def draw_tiers(axes: Any, places: Mapping[str, Any], values: Mapping[str, Any]) -> None:
    """The curves of all tiers that there are values of."""
    for tier, style in TIERS.items():
        if tier in values:
            axes.plot(places[tier], values[tier], **style)


MARGINS = {"left": 0.75, "right": 0.15, "bottom": 0.6, "top": 0.75, "across": 0.7, "up": 0.6}


def boxes(size: tuple[float, float], rows: int, columns: int, **margins: float) -> list[Box]:
    """Panels in rows from the top, as shares of a figure; MARGINS and gaps, or other ones, in
    inches."""
    left, right, bottom, top, across, up = {**MARGINS, **margins}.values()
    wide = (size[0] - left - right - (columns - 1) * across) / columns
    high = (size[1] - bottom - top - (rows - 1) * up) / rows
    places = [
        (left + k * (wide + across), bottom + (rows - 1 - j) * (high + up), wide, high)
        for j in range(rows)
        for k in range(columns)
    ]
    found = (np.array(places) / np.tile(size, 2)).tolist()
    return [(x, y, w, h) for x, y, w, h in found]


def label_decades(axes: Any) -> None:
    """Label 1, 2 and 5 of each decade of x where the axis has less than two, else the decades."""
    from matplotlib.ticker import LogLocator, NullFormatter

    low, high = axes.get_xlim()
    subs = (1.0, 2.0, 5.0) if high < 100.0 * low else (1.0,)
    axes.xaxis.set_major_locator(LogLocator(subs=subs))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_formatter("{x:g}")


def legend_above(axes: Any, columns: int, **changes: Any) -> None:
    """A legend in one line, or few, over a panel."""
    axes.legend(
        loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns, borderpad=0.2,
        columnspacing=1.2, handletextpad=0.5, **changes,
    )  # fmt: skip
