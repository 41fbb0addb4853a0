"""released_energy.png, released_heights.png: what the snap releases, and the arch's depths."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper import exact
from experiments.paper.released_energy.judge import (
    HEIGHTS,
    HIGH,
    LOW,
    Line,
    column,
    exact_value,
    shallow_slope,
    straight_line,
    within,
)
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

STYLES: tuple[dict[str, Any], ...] = (
    {"color": palette.BEAM, "ls": "-"},
    {"color": palette.CENTRE, "ls": (0, (5, 2))},
    {"color": palette.FORCE, "ls": (0, (1.2, 1.4))},
)
EXACT: dict[str, Any] = {
    "marker": "o",
    "ls": "",
    "ms": 6,
    "mfc": "none",
    "mec": palette.INK,
    "zorder": 5,
}
KEY = "energy_released_bar"


def draw_energy(curves: Mapping[float, Sequence[Row]], path: Path) -> None:
    """Energy with its line, deviation from lines, and energy over epsilon."""
    title = "Elastic energy released by the snap"
    with picture(path, (12.5, 4.8), title) as figure:
        boxes = [(0.06 + 0.33 * k, 0.14, 0.265, 0.7) for k in range(3)]
        _energy(figure.add_axes(boxes[0]), curves)
        _deviation(figure.add_axes(boxes[1]), curves[0.0])
        _ratio(figure.add_axes(boxes[2]), curves)
        for axes in figure.axes:
            axes.set_xlabel("pre-compression ε")
            axes.set_xlim(0.0, 0.31)
            axes.grid(True)


def draw_curves(axes: Any, curves: Mapping[float, Sequence[Row]], key: str, over: bool) -> None:
    """A number of the rows against epsilon, or that over epsilon, with exact ones."""
    for (delta_alpha, rows), style in zip(curves.items(), STYLES, strict=True):
        epsilon, values = column(rows, "epsilon"), column(rows, key)
        axes.plot(epsilon, values / epsilon if over else values, lw=2.2, **style,
                  label=f"Δα = {delta_alpha:g} rad")  # fmt: skip
        known = exact.SYMMETRIC if delta_alpha == 0.0 else exact.COMPARED
        for e in known:
            value = exact_value(e, delta_alpha, key)
            if value is not None:
                axes.plot(e, value / e if over else value, **EXACT)
    axes.plot([], [], **EXACT, label="exact")


def _energy(axes: Any, curves: Mapping[float, Sequence[Row]]) -> None:
    draw_curves(axes, curves, KEY, over=False)
    line = straight_line(within(curves[0.0]))
    ends = np.array([0.0, 0.3])
    axes.plot(ends, line.at(ends), color=palette.INK, lw=0.9, zorder=4,
              label="best line, ε from 0.1")  # fmt: skip
    axes.set_ylabel("released energy (EI/L)")
    axes.legend(loc="upper left")


def _deviation(axes: Any, alike: Sequence[Row]) -> None:
    """From the best lines over the paper's range and over all."""
    for rows, colour, line_style, words in (
        (within(alike), palette.BEAM, "-", "ε 0.1 to 0.3"),
        (alike, palette.PLUM, (0, (5, 2)), "all ε"),
    ):
        line = straight_line(rows)
        axes.plot(column(rows, "epsilon"), deviation(rows, line), color=colour, lw=2.2,
                  ls=line_style, label=f"from the best line for {words}")  # fmt: skip
    axes.axhline(0.0, color=palette.QUIET, lw=0.8)
    axes.set_ylim(-8.0, 8.0)
    axes.set_ylabel("released energy less the line (% of it)")
    axes.legend(loc="lower right")


def deviation(rows: Sequence[Row], line: Line) -> np.ndarray:
    """Of the released energy from a line, in percent of the energy."""
    return np.asarray(100.0 * (1.0 - line.at(column(rows, "epsilon")) / column(rows, KEY)))


def _ratio(axes: Any, curves: Mapping[float, Sequence[Row]]) -> None:
    draw_curves(axes, curves, KEY, over=True)
    slope = shallow_slope()
    axes.axhline(slope, color=palette.QUIET, lw=1.2, ls=":", label="shallow limit, Δα = 0")
    axes.set_ylim(0.4 * slope, 1.15 * slope)
    axes.set_ylabel("released energy / ε (EI/L)")
    axes.legend(loc="lower right")


LABELS = {
    "h1": "depth of the lowest point at the snap, h1 / L",
    "h2": "depth of the snapped arch's middle, h2 / L",
}
PROGRAM = {"color": palette.INK, "lw": 1.3, "label": "released program"}
OWN = {"color": palette.CLAMP, "marker": "s", "ms": 5, "lw": 1.0, "zorder": 4,
       "label": "two fixed nodes, Δα = 0"}  # fmt: skip


def draw_heights(
    curves: Mapping[float, Sequence[Row]], own_mesh: Sequence[Row], path: Path
) -> None:
    """Both depths; and all of them against the converged ones of clamps that turn alike."""
    title = "Depths of the arch, and the released program's polynomials"
    with picture(path, (12.5, 8.4), title) as figure:
        for k, name in enumerate(HEIGHTS):
            left = 0.07 + 0.5 * k
            depth = figure.add_axes((left, 0.53, 0.42, 0.37))
            _depth(depth, curves, own_mesh, name)
            against = figure.add_axes((left, 0.07, 0.42, 0.37))
            _differences(against, curves, own_mesh, name)
            for axes in (depth, against):
                axes.set_xlim(0.0, 0.31)
                axes.set_xlabel("pre-compression ε")
                axes.grid(True)


def _depth(
    axes: Any, curves: Mapping[float, Sequence[Row]], own_mesh: Sequence[Row], name: str
) -> None:
    draw_curves(axes, curves, f"{name}_bar", over=False)
    epsilon = np.linspace(LOW, HIGH, 41)
    axes.plot(epsilon, exact.released_height(name, epsilon), **PROGRAM)
    axes.plot(column(own_mesh, "epsilon"), column(own_mesh, f"{name}_bar"), **OWN)
    axes.set_ylabel(LABELS[name])
    axes.legend(loc="lower right")


def _differences(
    axes: Any, curves: Mapping[float, Sequence[Row]], own_mesh: Sequence[Row], name: str
) -> None:
    """In percent of the converged depth without a mismatch."""
    key = f"{name}_bar"
    converged = {row["epsilon"]: row[key] for row in curves[0.0]}

    def percent(epsilon: Any, values: Any) -> Any:
        own = np.array([converged[e] for e in epsilon])
        return 100.0 * (np.asarray(values) / own - 1.0)

    for (delta_alpha, rows), style in zip(curves.items(), STYLES, strict=True):
        epsilon = [row["epsilon"] for row in rows]
        axes.plot(epsilon, percent(epsilon, column(rows, key)), lw=2.2, **style)
        known = exact.SYMMETRIC if delta_alpha == 0.0 else exact.COMPARED
        values = [exact_value(e, delta_alpha, key) for e in known]
        if None not in values:
            axes.plot(known, percent(known, values), **EXACT)
    epsilon = [e for e in converged if LOW <= e <= HIGH]
    axes.plot(epsilon, percent(epsilon, exact.released_height(name, epsilon)), **PROGRAM)
    epsilon = [row["epsilon"] for row in own_mesh]
    axes.plot(epsilon, percent(epsilon, column(own_mesh, key)), **OWN)
    axes.set_ylabel(f"{name} differs from converged, Δα = 0, by (%)")
