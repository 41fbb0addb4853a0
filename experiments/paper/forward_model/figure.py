"""forward_model.png: how far the paper's network is off, and how near designs come."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from experiments.paper.forward_model.compute import PAPER_MAE_BAR, PAPER_MEAN_MM

from experiments.inverse_benchmark.table import column
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

COLOURS = (palette.QUIET, palette.BEAM, palette.FORCE, palette.CENTRE, palette.CLAMP)
LINES = ("-", "-", "-", "--", ":")
LIMITS_MM = (1e-3, 60.0)


def draw_forward_model(
    predictions: Sequence[Row], methods: Mapping[str, Sequence[Row]], path: Path
) -> None:
    """Errors of the predicted apexes of the test set; distributions of the misses of designs."""
    title = "The paper's network on jumps it has not seen, and designs for random targets"
    with picture(path, (13.0, 5.4), title) as figure:
        for k, name in enumerate(("x", "y")):
            axes = figure.add_axes((0.06 + 0.3 * k, 0.12, 0.22, 0.68))
            _errors(axes, predictions, name)
        _misses(figure.add_axes((0.68, 0.12, 0.3, 0.6)), methods)


def _errors(axes: Any, rows: Sequence[Row], name: str) -> None:
    simulated = column(rows, f"{name}_bar")
    off = column(rows, f"predicted_{name}_bar") - simulated
    axes.plot(simulated, off, "o", ms=2.2, mew=0.0, color=palette.BEAM, alpha=0.5)
    for side in (-PAPER_MAE_BAR, PAPER_MAE_BAR):
        axes.axhline(side, color=palette.INK, lw=1.0, ls=":")
    axes.set(
        xlabel=f"simulated {name}$_c$ / L",
        ylabel=f"predicted less simulated {name}$_c$ / L",
        title="dotted: the paper's mean error",
    )
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
    axes.legend(
        loc="lower left", bbox_to_anchor=(-0.12, 1.0), ncols=2, fontsize=9, columnspacing=1.2
    )
