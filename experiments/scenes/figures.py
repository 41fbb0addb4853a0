"""scenes.png: time with everything and as the scene has it, and how far the answer moves."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

WIDTH, ROW, MARGIN = 12.5, 0.75, 1.6  # inches
SMALLEST = 1e-10  # percent that is still drawn


def draw_savings(rows: Sequence[Row], path: Path) -> None:
    """A line for each comparison: milliseconds on the left, changes of x and y on the right."""
    height = ROW * len(rows) + MARGIN
    headline = "What scenes leave out: time, and change of the answer"
    with picture(path, (WIDTH, height), headline) as figure:
        low, tall = 0.75 / height, (height - MARGIN) / height
        times, moved = (figure.add_axes((left, low, 0.37, tall)) for left in (0.17, 0.60))
        for place, row in enumerate(reversed(rows)):
            times.barh(place + 0.18, row["full_ms"], 0.32, color=palette.PALE)
            times.barh(place - 0.18, row["scene_ms"], 0.32, color=palette.BEAM)
            times.text(max(row["full_ms"], row["scene_ms"]) * 1.03, place,
                       f"{row['saved_percent']:.0f} % saved", va="center")  # fmt: skip
            _changes(moved, place, row)
        names = [f"without\n{row['leaves_out']}" for row in reversed(rows)]
        for axes in (times, moved):
            axes.set_ylim(-0.6, len(rows) - 0.4)
            axes.grid(True, axis="x")
            axes.set_yticks(range(len(rows)), names if axes is times else [])
        times.set_xlim(0.0, 1.3 * times.get_xlim()[1])
        times.set_xlabel("ms a jump (grey: with it; blue: as the scene is)")
        moved.set(xscale="log", xlim=(SMALLEST, 1e2))
        moved.set_xlabel("change: median (dot) to largest (bar); green x, orange y (%)")


def _changes(axes: Any, place: int, row: Row) -> None:
    """Median and largest change of x and of y; what is below the axis is said in words."""
    if max(row["x_change_max_percent"], row["y_change_max_percent"]) < SMALLEST:
        axes.text(2.0 * SMALLEST, place, "no change", va="center", color=palette.QUIET)
        return
    for shift, key, colour in ((0.12, "x", palette.CENTRE), (-0.12, "y", palette.FORCE)):
        ends = [max(row[f"{key}_change_{s}_percent"], SMALLEST) for s in ("median", "max")]
        axes.plot(ends, [place + shift] * 2, color=colour, lw=4, alpha=0.45)
        axes.plot(ends[:1], [place + shift], "o", color=colour, ms=7)
        axes.plot(ends[1:], [place + shift], "|", color=colour, ms=10, mew=2)
