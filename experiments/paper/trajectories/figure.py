"""trajectories.png: flights to scale; trajectories_angles.png: how oblique, and the way up."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper.jumps import numbers
from experiments.paper.trajectories.compute import FAMILIES
from experiments.paper.trajectories.judge import ratios
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

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


def draw_angles(
    sweeps: Mapping[str, Sequence[Row]], paths: Mapping[float, Sequence[Row]], path: Path
) -> None:
    """Ratios on the left; paths on the ground, stretched sideways, on the right."""
    with picture(path, (13.0, 5.2), "How the mismatch turns a jump") as figure:
        angles, before = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.06, right=0.985, bottom=0.125, top=0.83, wspace=0.17)
        lags = {tier: numbers(rows, "delta_alpha_rad") for tier, rows in sweeps.items()}
        drawn = {
            "standard": {"color": palette.BEAM, "lw": 2.2},
            "paper": {"color": palette.FORCE, "lw": 1.5, "ls": DASHES},
            "reference": {"color": palette.INK, "ls": "", "marker": "o", "ms": 4.5, "mfc": "none"},
        }
        for tier, style in drawn.items():
            label = "the paper's settings" if tier == "paper" else tier
            angles.plot(lags[tier], ratios(sweeps[tier]), label=label, **style)
        angles.set(xlabel="mismatch Δα (rad)", ylabel="$x_c$ / $y_c$ of the apex")
        angles.set_title("how far aside for the height", loc="left")
        angles.legend(loc="lower right")
        angles.grid(True)

        for colour, dash, (lag, rows) in zip(
            COLOURS,
            ("-", DASHES, (0, (1, 1.2)), (0, (6, 1.5, 1, 1.5))),
            paths.items(),
            strict=False,
        ):
            x, y = numbers(rows, "x_bar"), numbers(rows, "y_bar")
            before.plot(x, y, color=colour, ls=dash, lw=2.2, label=f"Δα = {lag:g}")
            touching = numbers(rows, "ground_force_N") > 0.0
            last = int(touching.nonzero()[0][-1])
            before.plot(x[last], y[last], "o", color=colour, ms=7)
        before.set(xlabel="x / L (stretched)", ylabel="y / L")
        before.set_title("centre of mass from rest; dots: the last contact", loc="left")
        before.legend(loc="lower right")
        before.grid(True)
