"""modelling.png: how far x and y move with each number of the model, beside the tiers' errors."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from snapjump.plots import palette
from snapjump.plots.saving import picture

WIDTH, ROW, MARGIN = 12.0, 0.34, 1.5  # inches
KINDS = {
    "model": palette.CLAMP,
    "numerics": palette.BEAM,
    "numerics and model": palette.VIOLET,
}
COORDINATES = {"x": "change or error of x (%)", "y": "change or error of y (%)"}


def draw_modelling(rows: Sequence[dict[str, Any]], path: Path) -> None:
    """A line from the median to the 95th percentile, largest first."""
    ordered = sorted(rows, key=lambda row: row.get("x_median_percent") or 0.0)
    height = ROW * len(ordered) + MARGIN
    headline = "Which uncertainty dominates: median (dot) to 95th percentile (bar)"
    with picture(path, (WIDTH, height), headline) as figure:
        for k, (coordinate, label) in enumerate(COORDINATES.items()):
            box = (0.19 + 0.41 * k, 0.65 / height, 0.385, (height - MARGIN) / height)
            axes = figure.add_axes(box)
            for place, row in enumerate(ordered):
                median, p95 = (row.get(f"{coordinate}_{s}_percent") for s in ("median", "p95"))
                colour = KINDS[row["kind"]]
                if median is not None and p95 is not None:
                    axes.plot([median, p95], [place, place], color=colour, lw=4, alpha=0.45)
                    axes.plot([p95], [place], "|", color=colour, ms=10, mew=2)
                if median is not None:
                    axes.plot([median], [place], "o", color=colour, ms=7)
            axes.set_xscale("log")
            axes.set_ylim(-0.7, len(ordered) - 0.3)
            axes.grid(True, axis="x")
            axes.set_xlabel(label)
            axes.set_yticks(
                range(len(ordered)), [row["source"] for row in ordered] if k == 0 else []
            )
        _legend(figure, height)


def _legend(figure: Any, height: float) -> None:
    from matplotlib.lines import Line2D

    figure.legend(
        handles=[Line2D([], [], color=c, lw=4, label=name) for name, c in KINDS.items()],
        loc="upper right",
        bbox_to_anchor=(0.985, 1.0 - 0.42 / height),
        ncols=3,
    )
