"""influences_height.png: apex against the mounts' height, with the depths of the arch."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from experiments.paper.influences.figure import COORDINATES, draw_tiers
from experiments.paper.influences.sweeps import MOUNT_HEIGHT, SWEEPS
from experiments.paper.jumps import numbers
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row


def draw_heights(sweep: Mapping[str, Sequence[Row]], statics: Row, path: Path) -> None:
    """x on the left, y on the right."""
    with picture(path, (13.0, 5.0), "Height of the clamps above the feet") as figure:
        panels = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.05, right=0.99, bottom=0.125, top=0.85, wspace=0.13)
        for axes, (key, label) in zip(panels, COORDINATES.items(), strict=True):
            draw_tiers(axes, sweep, MOUNT_HEIGHT, {t: numbers(sweep[t], key) for t in sweep})
            for name in ("h1", "h2"):
                place = statics[f"{name}_bar"]
                axes.axvline(place, color=palette.QUIET, lw=1.2, ls=":")
                axes.annotate(
                    name, (place, 1.0), (0, 3), color=palette.QUIET, ha="center",
                    xycoords=("data", "axes fraction"), textcoords="offset points",
                )  # fmt: skip
            axes.set(xlabel=SWEEPS[MOUNT_HEIGHT].label, ylabel=label)
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper right", ncols=3, bbox_to_anchor=(0.99, 0.985))
