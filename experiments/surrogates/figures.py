"""curves.png and places.png: error against jumps and time, and where it is."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

from ..designs import AXES

COLOURS = {
    "mlp": palette.FORCE,
    "resnet": palette.BEAM,
    "ensemble": palette.CENTRE,
    "rbf": palette.QUIET,
    "gradient_mlp": palette.VIOLET,
}
FASTEST_S = 10.0  # of a training that is shown: what is not trained takes no time
MARKS = {"of the paper's tier": "s", "with slopes": "^", "slopes left out": "v"}


def draw_curves(table: Sequence[Row], floors: Sequence[Row], paper: float, path: Path) -> None:
    """MAE against jumps and against seconds of training; the floors as lines."""
    from matplotlib.ticker import NullFormatter

    labels = {"jumps": "jumps learned from", "train_seconds": "training on one core (s)"}
    title = "Forward models: error on the held-out standard grid"
    with picture(path, (13.0, 5.6), title) as figure:
        for k, (key, label) in enumerate(labels.items()):
            axes = figure.add_axes((0.065 + 0.42 * k, 0.13, 0.36, 0.73))
            _lines(axes, table, key)
            axes.axhline(paper, color=palette.INK, lw=1, ls=":")
            for row in floors:
                axes.axhline(row["mean_bar"], color=palette.CLAMP, lw=1,
                             ls="--" if row["tier"] == "paper" else "-")  # fmt: skip
            axes.set(xscale="log", yscale="log", xlabel=label)
            axes.grid(True, which="both")
            if key == "jumps":
                axes.set_ylabel("mean absolute error, x and y averaged (L)")
            else:
                axes.set_xlim(left=FASTEST_S)
                axes.xaxis.set_minor_formatter(NullFormatter())
        handles, names = axes.get_legend_handles_labels()
        figure.legend(handles, names, loc="upper left", bbox_to_anchor=(0.855, 0.87))
        words = [(paper, "the paper's MAE", palette.INK)]
        words += [(r["mean_bar"], f"cubic in a cell, {r['tier']}", palette.CLAMP) for r in floors]
        for height, text, colour in words:
            axes.text(0.015, 1.03 * height, text, transform=axes.get_yaxis_transform(),
                      color=colour, va="bottom")  # fmt: skip


def _lines(axes: Any, table: Sequence[Row], key: str) -> None:
    """Members as lines over their sizes, and the special trainings as marks of their own."""
    by_member: dict[str, list[Row]] = {}
    for row in table:
        by_member.setdefault(row["surrogate"].split(",")[0], []).append(row)
    for member, rows in by_member.items():
        colour = COLOURS.get(member, palette.SKY)
        plain = [row for row in rows if not any(words in row["surrogate"] for words in MARKS)]
        plain.sort(key=lambda row: int(row["jumps"]))
        if plain:
            x, y = ([row[k] for row in plain] for k in (key, "mae_bar"))
            axes.plot(x, y, "o-", color=colour, lw=2, ms=5, label=member)
        for words, mark in MARKS.items():
            for row in rows:
                if words in row["surrogate"]:
                    axes.plot([row[key]], [row["mae_bar"]], mark, ms=8, mfc="none", color=colour,
                              label=f"{member}\n{words}")  # fmt: skip


def draw_places(rows: Sequence[Row], path: Path) -> None:
    """Mean absolute errors of x and y in fifths of each input."""
    with picture(path, (13.0, 3.9), "Where the error sits") as figure:
        for k, axis in enumerate(AXES):
            axes = figure.add_axes((0.065 + 0.238 * k, 0.17, 0.2, 0.62))
            ours = [row for row in rows if row["input"] == axis.column]
            middles = np.array([0.5 * (row["from"] + row["to"]) for row in ours])
            width = 0.38 * (ours[0]["to"] - ours[0]["from"])
            for shift, key, colour in ((-0.5, "x", palette.BEAM), (0.5, "y", palette.FORCE)):
                heights = [row[f"mae_{key}_bar"] for row in ours]
                axes.bar(middles + shift * width, heights, width, color=colour, label=key)
            axes.set_xlabel(axis.label)
            axes.grid(True, axis="y")
            axes.set_ylim(0.0, 1.08 * max(max(r["mae_x_bar"], r["mae_y_bar"]) for r in rows))
            if k == 0:
                axes.set_ylabel("MAE (L)")
                axes.legend(loc="upper right")
            else:
                axes.tick_params(labelleft=False)
