"""Errors of the model beside numerical errors: changes of the answer by what is modelled."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import OK, Done
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

from ..compositions import Groups, changed, has_field
from ..errors import error_figures, relative_errors
from .points import Point, split

# Family, key, symbol, and its values: factors of the configured one, or values in a unit.
NUMBERS = (
    ("contact", "distance_m", "d_hat", (0.5, 2.0), "factors"),
    ("contact", "stiffness_N_m", "K", (0.1, 10.0), "factors"),
    ("damping", "relaxation_time_s", "eta", (0.0, 1e-6, 1e-5, 1e-4), "s"),
    ("friction", "velocity_threshold_m_s", "eps_v", (1e-5, 1e-4, 1e-3), "m/s"),
    ("contact", "damping_s", "contact damping", (0.0, 1e-7, 1e-6, 1e-5), "s"),
)
DEFAULT = "as configured"
WIDTH, ROW, MARGIN = 12.0, 0.34, 1.5  # inches
KINDS = {"model": palette.CLAMP, "numerics": palette.BEAM, "numerics and model": palette.VIOLET}
COORDINATES = {"x": "change or error of x (%)", "y": "change or error of y (%)"}


def models(base: Groups) -> dict[str, Groups]:
    """The configured model first, then each that differs from it in one number."""
    found = {DEFAULT: base}
    for family, key, symbol, values, unit in NUMBERS:
        if not has_field(base, family, key):
            continue
        configured = base[family].get(key, 0.0)
        for value in values:
            name = f"{symbol} = {value:g} {unit}"
            if unit == "factors":
                name, value = f"{symbol} x {value:g}", float(configured) * value
            if value != configured:
                found[name] = changed(base, {family: {key: value}})
    return found


def shifts(done: Mapping[str, Done]) -> list[dict[str, Any]]:
    """Changes of x and y (%) by each model from the configured one; failures are infinite."""
    x0, y0 = split(done[DEFAULT])["design"]
    rows = []
    for name, cell in done.items():
        if name == DEFAULT:
            continue
        row: dict[str, Any] = {"source": name, "kind": "model"}
        if cell.status == OK:
            x, y = split(cell)["design"]
            figures = error_figures(*relative_errors(x, y, x0, y0))
            row |= {key: value for key, value in figures.items() if np.isfinite(value)}
        rows.append(row)
    return sorted(rows, key=lambda row: -row.get("x_median_percent", 0.0))


def tier_errors(points: Mapping[str, Point]) -> list[dict[str, Any]]:
    """The tiers' numerical errors in the same columns; ``paper`` is another model, too."""
    return [
        {
            "source": f"tier {name}",
            "kind": "numerics" if name != "paper" else "numerics and model",
            **point.errors,
        }
        for name, point in points.items()
    ]


def draw_modelling(rows: Sequence[dict[str, Any]], path: Path) -> None:
    """A line from the median to the 95th percentile, largest first."""
    from matplotlib.lines import Line2D

    ordered = sorted(rows, key=lambda row: row.get("x_median_percent") or 0.0)
    height = ROW * len(ordered) + MARGIN
    headline = "Which uncertainty dominates: median (dot) to 95th percentile (bar)"
    with picture(path, (WIDTH, height), headline) as figure:
        for k, (coordinate, label) in enumerate(COORDINATES.items()):
            box = (0.19 + 0.41 * k, 0.65 / height, 0.385, (height - MARGIN) / height)
            axes = figure.add_axes(box)
            for place, row in enumerate(ordered):
                median, p95 = (row.get(f"{coordinate}_{s}_percent") for s in ("median", "p95"))
                colour = KINDS[row["kind"]]
                if median is not None and p95 is not None:
                    axes.plot([median, p95], [place, place], color=colour, lw=4, alpha=0.45)
                    axes.plot([p95], [place], "|", color=colour, ms=10, mew=2)
                if median is not None:
                    axes.plot([median], [place], "o", color=colour, ms=7)
            axes.set(xscale="log", ylim=(-0.7, len(ordered) - 0.3), xlabel=label)
            axes.grid(True, axis="x")
            names = [row["source"] for row in ordered] if k == 0 else []
            axes.set_yticks(range(len(ordered)), names)
        handles = [Line2D([], [], color=c, lw=4, label=name) for name, c in KINDS.items()]
        corner = (0.985, 1.0 - 0.42 / height)
        figure.legend(handles=handles, loc="upper right", bbox_to_anchor=corner, ncols=3)
