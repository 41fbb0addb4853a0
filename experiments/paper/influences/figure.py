"""influences.png: apex against pre-compression, mismatch, friction and mass."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from experiments.paper.baseline import BASELINE, NAMES, RANGES
from experiments.paper.influences.sweeps import SWEEPS
from experiments.paper.jumps import numbers
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

COORDINATES = {"x_bar": "$x_c$ / L", "y_bar": "$y_c$ / L"}
STYLES: dict[str, dict[str, Any]] = {
    "standard": {"color": palette.BEAM, "lw": 2.2},
    "paper": {"color": palette.FORCE, "lw": 1.4, "ls": (0, (5, 2.5))},
    "paper, short step": {"color": palette.CENTRE, "lw": 1.3, "ls": (0, (1, 1.2))},
    "reference": {"color": palette.INK, "ls": "", "marker": "o", "ms": 4.2, "mfc": "none"},
}
LABELS = {
    "standard": "standard",
    "paper": "the paper's settings",
    "paper, short step": "the same with a tenth of its step",
    "reference": "reference",
}


def draw_tiers(
    axes: Any, sweep: Mapping[str, Sequence[Row]], place: str, values: Mapping[str, Any]
) -> None:
    """The curves of all tiers; values: by tier."""
    for tier, style in STYLES.items():
        if tier in values:
            axes.plot(numbers(sweep[tier], place), values[tier], label=LABELS[tier], **style)
    axes.grid(True)


def draw_influences(sweeps: Mapping[str, Mapping[str, Sequence[Row]]], path: Path) -> None:
    """A column for each parameter; x above, y below."""
    with picture(path, (14.0, 7.0), "One parameter at a time about the baseline") as figure:
        grid = figure.subplots(2, len(sweeps), sharex="col")
        figure.subplots_adjust(
            left=0.052, right=0.99, bottom=0.085, top=0.88, wspace=0.2, hspace=0.1
        )
        for column, (kind, sweep) in enumerate(sweeps.items()):
            for row, (key, label) in enumerate(COORDINATES.items()):
                axes = grid[row, column]
                draw_tiers(axes, sweep, kind, {t: numbers(sweep[t], key) for t in sweep})
                first, last = SWEEPS[kind].first, SWEEPS[kind].last
                low, high = RANGES[kind]
                if (low, high) != (first, last):
                    axes.axvspan(low, high, color=palette.SHADE, zorder=0)
                axes.axvline(BASELINE[NAMES.index(kind)], color=palette.QUIET, lw=1.0, ls=":")
                axes.set_ylim(bottom=0.0)
                axes.set_xlim(first, last)
                if column == 0:
                    axes.set_ylabel(label)
                if row == 1:
                    axes.set_xlabel(SWEEPS[kind].label)
        handles, labels = grid[0, 1].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper right", ncols=4, bbox_to_anchor=(0.99, 0.985))
