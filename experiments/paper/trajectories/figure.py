"""trajectories.png: flights to scale; trajectories_angles.png: how oblique, and the way up."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ...styles import DASHES, SERIES, boxes, draw_tiers, legend_above
from ..settings import LABELS

FLIGHTS, ANGLES = (13.0, 6.4), (13.0, 5.2)


def draw_flights(
    families: Mapping[str, Sequence[float]], flights: Mapping[str, Sequence[Row]], path: Path
) -> None:
    """A panel for each number that varies; flights by tier, in the order of the families."""
    title = "Flights of the centre of mass (lines: standard; dashed: the paper's settings)"
    places = boxes(FLIGHTS, 1, len(families), top=1.25, across=0.45)
    begun = 0
    with panels(path, FLIGHTS, title, *places) as drawn:
        for axes, (name, values) in zip(drawn, families.items(), strict=True):
            for k, value in enumerate(values):
                for tier, rows in flights.items():
                    draw_flight(axes, rows[begun + k], tier == "standard", SERIES[k], f"{value:g}")
            begun += len(values)
            axes.set_title(f"{LABELS[name]}, all else as the baseline", loc="left", pad=34)
            legend_above(axes, len(values), handlelength=1.4)
            axes.set(xlabel="x / L", aspect="equal", xlim=(-1.0, 20.0), ylim=(0.0, 24.5))
            axes.set_xticks(range(0, 21, 5))
        drawn[0].set_ylabel("y / L")


def draw_flight(axes: Any, row: Row, own: bool, style: tuple[str, str, Any], label: str) -> None:
    """A flight at standard, with a label, or at another tier."""
    colour, mark, _ = style
    axes.plot(*flight(row), color=colour, lw=2.0 if own else 1.3, ls="-" if own else DASHES)
    axes.plot(row["x_bar"], row["y_bar"], mark, color=colour, ms=7, zorder=3,
              mfc=colour if own else palette.PAPER, label=label if own else None)  # fmt: skip


def flight(row: Row) -> tuple[Any, Any]:
    """The parabola from lift-off over the apex down to the height of lift-off (L)."""
    low, high = column([row], "liftoff_y_bar")[0], row["y_bar"]
    share = np.linspace(-1.0, 1.0, 121)  # of the time from lift-off to apex
    x = row["x_bar"] + share * (row["x_bar"] - row["liftoff_x_bar"])
    return x, high - share**2 * (high - low)


def draw_angles(
    sweeps: Mapping[str, Sequence[Row]],
    ratios: Mapping[str, Any],
    paths: Mapping[float, Sequence[Row]],
    path: Path,
) -> None:
    """Ratios on the left; paths on the ground, stretched sideways, on the right."""
    places = boxes(ANGLES, 1, 2, top=0.9, across=0.95)
    with panels(path, ANGLES, "How the mismatch turns a jump", *places) as (angles, before):
        lags = {tier: column(rows, "delta_alpha_rad") for tier, rows in sweeps.items()}
        draw_tiers(angles, lags, ratios)
        angles.set(xlabel=LABELS["delta_alpha_rad"], ylabel="$x_c$ / $y_c$ of the apex")
        angles.set_title("how far aside for the height", loc="left")
        for (colour, _, line), (lag, rows) in zip(SERIES, paths.items(), strict=False):
            x, y = column(rows, "x_bar"), column(rows, "y_bar")
            before.plot(x, y, color=colour, ls=line, lw=2.2, label=f"Δα = {lag:g}")
            last = int(np.flatnonzero(column(rows, "ground_force_N") > 0.0)[-1])
            before.plot(x[last], y[last], "o", color=colour, ms=7)
        before.set(xlabel="x / L (stretched)", ylabel="y / L")
        before.set_title("centre of mass from rest; dots: the last contact", loc="left")
        for axes in (angles, before):
            axes.legend(loc="lower right")
