"""forward_model.png: what the paper's network predicts, and how near designs come."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.inverse_benchmark.table import column
from experiments.paper.forward_model.methods import PAPER_MEAN_MM
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

COLOURS = (palette.QUIET, palette.BEAM, palette.FORCE, palette.CENTRE, palette.CLAMP)
LINES = ("-", "-", "-", "--", ":")
LIMITS_MM = (1e-3, 60.0)


def draw_forward_model(
    predictions: Sequence[Row], methods: Mapping[str, Sequence[Row]], path: Path
) -> None:
    """Predicted against simulated apexes of the test set; distributions of the misses."""
    title = "The paper's network on jumps it has not seen, and designs for random targets"
    with picture(path, (13.0, 5.0), title) as figure:
        for k, name in enumerate(("x", "y")):
            axes = figure.add_axes((0.06 + 0.3 * k, 0.13, 0.22, 0.7))
            _predictions(axes, predictions, name)
        _misses(figure.add_axes((0.68, 0.13, 0.3, 0.7)), methods)


def _predictions(axes: Any, rows: Sequence[Row], name: str) -> None:
    simulated, told = column(rows, f"{name}_bar"), column(rows, f"predicted_{name}_bar")
    axes.plot(simulated, told, "o", ms=2.0, mew=0.0, color=palette.BEAM, alpha=0.6)
    low, high = simulated.min(), simulated.max()
    axes.plot([low, high], [low, high], color=palette.INK, lw=0.8)
    axes.set(xlabel=f"simulated {name}$_c$ / L", ylabel=f"predicted {name}$_c$ / L")
    axes.grid(True)


def _misses(axes: Any, methods: Mapping[str, Sequence[Row]]) -> None:
    for (name, rows), colour, line in zip(methods.items(), COLOURS, LINES, strict=True):
        misses = column(rows, "miss_standard_mm")
        misses = np.sort(misses[np.isfinite(misses)])
        share = 100.0 * np.arange(1, len(misses) + 1) / max(len(rows), 1)
        label = f"{name} ({len(rows)})"
        axes.step(misses, share, where="post", color=colour, lw=2.0, ls=line, label=label)
    axes.axvline(PAPER_MEAN_MM, color=palette.INK, lw=1.0, ls=":")
    words = {"rotation": 90, "ha": "right", "va": "bottom", "color": palette.QUIET}
    axes.text(0.9 * PAPER_MEAN_MM, 2.0, "the paper's mean", **words)
    axes.set(xscale="log", xlim=LIMITS_MM, ylim=(0.0, 101.0))
    axes.set(xlabel="simulated miss (mm, L = 20 mm)", ylabel="share of targets (%)")
    axes.grid(True)
    axes.legend(loc="upper left", fontsize=9)
