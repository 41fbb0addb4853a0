"""misses.png: how far from their targets the methods' designs really get, and what that costs."""

from collections.abc import Mapping, Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

from .methods import PAPER, TIERS

COLOURS = (palette.QUIET, *palette.SERIES)
LIMITS_MM = (3e-4, 60.0)


def draw_benchmark(methods: Mapping[str, Sequence[Row]], path: Path) -> None:
    """Distributions of the misses at both tiers, and mean miss against time."""
    title = "Inverse design: simulated misses at L = 20 mm"
    with picture(path, (14.0, 6.2), title) as figure:
        for k, tier in enumerate(TIERS):
            axes = figure.add_axes((0.05 + 0.325 * k, 0.2, 0.27, 0.66))
            _distributions(axes, methods, tier)
            if k == 0:
                axes.set_ylabel("share of targets (%)")
                place = (0.0, -0.13)
                axes.legend(loc="upper left", bbox_to_anchor=place, ncols=4, columnspacing=1.4)
        _costs(figure.add_axes((0.715, 0.2, 0.27, 0.66)), methods)


def _distributions(axes: Any, methods: Mapping[str, Sequence[Row]], tier: str) -> None:
    axes.set_title(f"judged at {tier}", loc="left")
    for colour, (name, rows) in zip(cycle(COLOURS), methods.items(), strict=False):
        misses = column(rows, f"miss_{tier}_mm")
        misses = np.sort(misses[np.isfinite(misses)])
        share = 100.0 * np.arange(1, len(misses) + 1) / max(len(rows), 1)
        axes.step(misses, share, where="post", color=colour, lw=2.0, label=name)
    mean = float(str(PAPER[0]["mean_mm"]))
    axes.axvline(mean, color=palette.INK, lw=1.0, ls=":")
    axes.text(0.92 * mean, 4.0, "the paper's mean", rotation=90, ha="right", va="bottom",
              color=palette.QUIET)  # fmt: skip
    axes.set(xscale="log", xlim=LIMITS_MM, ylim=(0.0, 101.0), xlabel="miss (mm)")
    axes.grid(True)


def _costs(axes: Any, methods: Mapping[str, Sequence[Row]]) -> None:
    axes.set_title("mean, judged at reference; squares: the paper", loc="left")
    # Methods of one kind lie side by side: the legend names them.
    for colour, rows in zip(cycle(COLOURS), methods.values(), strict=False):
        misses = column(rows, "miss_reference_mm")
        seconds = float(np.median(column(rows, "seconds")))
        mean = float(np.nanmean(misses))
        axes.plot(seconds, mean, "o", ms=9, color=colour, mec=palette.INK)
    for row in PAPER:
        place = float(str(row["seconds"])), float(str(row["mean_mm"]))
        axes.plot(*place, "s", ms=7, mfc="none", color=palette.INK)
        words = str(row["method"]).removeprefix("the paper: ")
        axes.annotate(words, place, (-8, -4), color=palette.INK, ha="right",
                      textcoords="offset points")  # fmt: skip
    axes.set(xscale="log", yscale="log", xlim=(1e-3, 4e3), ylim=(None, 8.0))
    axes.set(xlabel="time for one target (s)", ylabel="mm")
    axes.grid(True)
