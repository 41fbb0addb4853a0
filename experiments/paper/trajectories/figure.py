"""trajectories.png: flights of the centre of mass, to scale."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper.jumps import numbers
from experiments.paper.trajectories.families import FAMILIES
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

COLOURS = (palette.QUIET, palette.BEAM, palette.CENTRE, palette.FORCE, palette.PLUM)
DASHES = (0, (5, 2.5))
MARKS = "osD^v"
TITLES = {
    "delta_alpha_rad": "mismatch Δα (rad)",
    "epsilon": "pre-compression ε",
    "mass_bar": "mass m̄",
}


def draw_flights(flights: Mapping[str, Sequence[Row]], path: Path) -> None:
    """A panel for each number that varies."""
    headline = "Flights of the centre of mass (lines: standard; dashed: the paper's settings)"
    with picture(path, (13.0, 6.4), headline) as figure:
        panels = figure.subplots(1, len(FAMILIES), sharey=True)
        figure.subplots_adjust(left=0.055, right=0.985, bottom=0.09, top=0.82, wspace=0.08)
        begun = 0
        for axes, (name, values) in zip(panels, FAMILIES.items(), strict=True):
            for k, value in enumerate(values):
                rows = {tier: found[begun + k] for tier, found in flights.items()}
                _flight(axes, rows, COLOURS[k], MARKS[k], f"{value:g}")
            begun += len(values)
            axes.set_title(f"{TITLES[name]}, all else as the baseline", loc="left", pad=34)
            axes.legend(
                loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=len(values), borderpad=0.1,
                columnspacing=1.0, handletextpad=0.4, handlelength=1.4,
            )  # fmt: skip
            axes.set(xlabel="x / L", aspect="equal", xlim=(-1.0, 20.0), ylim=(0.0, 24.5))
            axes.set_xticks(range(0, 21, 5))
            axes.grid(True)
        panels[0].set_ylabel("y / L")


def _flight(axes: Any, rows: Mapping[str, Row], colour: str, mark: str, label: str) -> None:
    for tier, row in rows.items():
        own = tier == "standard"
        x, y = flight(row)
        axes.plot(x, y, color=colour, lw=2.0 if own else 1.3, ls="-" if own else DASHES)
        apex = row["x_bar"], row["y_bar"]
        axes.plot(*apex, mark, color=colour, ms=7, mfc=colour if own else palette.PAPER,
                  zorder=3, label=label if own else None)  # fmt: skip


def flight(row: Row) -> tuple[Any, Any]:
    """The parabola from lift-off over the apex down to the height of lift-off (L)."""
    low, high = numbers([row], "liftoff_y_bar")[0], row["y_bar"]
    share = np.linspace(-1.0, 1.0, 121)  # of the time from lift-off to apex
    x = row["x_bar"] + share * (row["x_bar"] - row["liftoff_x_bar"])
    return x, high - share**2 * (high - low)
