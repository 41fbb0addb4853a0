"""scenes.png: time with everything and as the scene has it, and how far the answer moves."""

from collections.abc import Sequence
from pathlib import Path

from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

WIDTH, ROW, MARGIN = 12.5, 0.75, 1.6  # inches
SMALLEST = 1e-6  # percent that is still drawn


def draw_savings(rows: Sequence[Row], path: Path) -> None:
    """A line for each comparison: milliseconds on the left, changes of x and y on the right."""
    height = ROW * len(rows) + MARGIN
    with picture(
        path, (WIDTH, height), "What scenes leave out: time, and change of the answer"
    ) as f:
        times = f.add_axes((0.17, 0.75 / height, 0.37, (height - MARGIN) / height))
        moved = f.add_axes((0.60, 0.75 / height, 0.37, (height - MARGIN) / height))
        for place, row in enumerate(reversed(rows)):
            times.barh(place + 0.18, row["full_ms"], 0.32, color=palette.PALE)
            times.barh(place - 0.18, row["scene_ms"], 0.32, color=palette.BEAM)
            times.text(max(row["full_ms"], row["scene_ms"]) * 1.1, place,
                       f"{row['saved_percent']:.0f} % saved", va="center")  # fmt: skip
            for shift, key, colour in ((0.12, "x", palette.CENTRE), (-0.12, "y", palette.FORCE)):
                low, high = (
                    max(row[f"{key}_change_{s}_percent"], SMALLEST) for s in ("median", "max")
                )
                moved.plot([low, high], [place + shift] * 2, color=colour, lw=4, alpha=0.45)
                moved.plot([low], [place + shift], "o", color=colour, ms=7)
                moved.plot([high], [place + shift], "|", color=colour, ms=10, mew=2)
        names = [f"without\n{row['leaves_out']}" for row in reversed(rows)]
        for axes in (times, moved):
            axes.set_xscale("log")
            axes.set_ylim(-0.6, len(rows) - 0.4)
            axes.grid(True, axis="x")
            axes.set_yticks(range(len(rows)), names if axes is times else [])
        low, high = times.get_xlim()
        times.set_xlim(low, high * (high / low) ** 0.35)
        times.set_xlabel("ms a jump (grey: with it; blue: as the scene is)")
        moved.set_xlabel("change: median (dot) to largest (bar); green x, orange y (%)")
