"""forward_model.png: how far the paper's network is off, and how near designs come."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ..limits import LIMITS

COLOURS = (palette.QUIET, palette.BEAM, palette.FORCE, palette.CENTRE, palette.CLAMP)
LINES = ("-", "-", "-", "--", ":")
PAPER_MAE_BAR, PAPER_MEAN_MM = (
    LIMITS[f"forward_model.{key}"].confirmed for key in ("error", "accuracy")
)


def draw_forward_model(
    predictions: Sequence[Row], methods: Mapping[str, Sequence[Row]], path: Path
) -> None:
    """Errors of the predicted apexes of the test set; distributions of the misses of designs."""
    title = "The paper's network on jumps it has not seen, and designs for random targets"
    boxes = (0.06, 0.12, 0.22, 0.68), (0.36, 0.12, 0.22, 0.68), (0.68, 0.12, 0.3, 0.6)
    with panels(path, (13.0, 5.4), title, *boxes) as (*pair, last):
        for name, axes in zip("xy", pair, strict=True):
            _errors(axes, predictions, name)
        _misses(last, methods)


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
    axes.set(xscale="log", xlim=(1e-3, 60.0), ylim=(0.0, 101.0))
    axes.set(xlabel="simulated miss (mm, L = 20 mm)", ylabel="share of targets (%)")
    axes.legend(
        loc="lower left", bbox_to_anchor=(-0.12, 1.0), ncols=2, fontsize=9, columnspacing=1.2
    )
