"""causes.png: how far the apex moves when one choice is exchanged."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

from ...errors import Shift

WIDTH, ROW, MARGIN = 13.0, 0.5, 1.75  # inches
SMALLEST, LARGEST = 3e-3, 60.0  # percent that is drawn
SIDES = {
    "paper": ("exchanged in the paper's settings", palette.FORCE, "s", 0.15),
    "reference": ("exchanged in the converged settings", palette.BEAM, "o", -0.15),
}


def draw_causes(moved: Mapping[tuple[str, str], Shift], apart: Shift, path: Path) -> None:
    """A line for each choice; x on the left, y on the right."""
    titles = list(dict.fromkeys(title for _, title in moved))
    height = ROW * (len(titles) + 1) + MARGIN
    with picture(path, (WIDTH, height), "What causes the difference") as figure:
        low, tall = 0.65 / height, (height - MARGIN) / height
        panels = {
            "x": figure.add_axes((0.175, low, 0.4, tall)),
            "y": figure.add_axes((0.59, low, 0.4, tall)),
        }
        for key, axes in panels.items():
            for place, title in enumerate(reversed(titles)):
                for end, (_, colour, mark, beside) in SIDES.items():
                    _bar(axes, place + beside, moved[end, title], key, colour, mark)
            _bar(axes, len(titles), apart, key, palette.INK, "D")
            axes.set_xscale("log")
            axes.set_xlim(SMALLEST, LARGEST)
            axes.set_ylim(-0.6, len(titles) + 0.6)
            axes.set_xticks([0.01, 0.1, 1.0, 10.0], ["0.01", "0.1", "1", "10"])
            axes.axhline(len(titles) - 0.5, color=palette.PALE, lw=1.0)
            axes.grid(True, axis="x")
            axes.set_xlabel(f"shift of ${key}_c$ (%)")
            names = [*reversed(titles), "all: paper to reference"]
            axes.set_yticks(range(len(names)), names if key == "x" else [])
        _legend(figure, height)


def _bar(axes: Any, place: float, found: Shift, key: str, colour: str, mark: str) -> None:
    median, p95 = getattr(found, f"{key}_median"), getattr(found, f"{key}_p95")
    if p95 < SMALLEST:
        words = f"< {SMALLEST:g} %"
        axes.text(1.15 * SMALLEST, place, words, va="center", fontsize=9, color=colour)
        return
    ends = [max(median, SMALLEST), min(p95, LARGEST)]
    axes.plot(ends, [place, place], color=colour, lw=3.5, alpha=0.45)
    axes.plot(ends[:1], [place], mark, color=colour, ms=7)
    axes.plot(ends[1:], [place], "|", color=colour, ms=10, mew=2)


def _legend(figure: Any, height: float) -> None:
    from matplotlib.lines import Line2D

    figure.legend(
        handles=[
            Line2D([], [], color=colour, marker=mark, lw=3.5, label=label)
            for label, colour, mark, _ in SIDES.values()
        ],
        loc="upper right",
        bbox_to_anchor=(0.99, 1.0 - 0.45 / height),
        ncols=2,
    )
