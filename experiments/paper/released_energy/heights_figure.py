"""released_heights.png: the depths h1 and h2, and the released program's polynomials."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper import exact
from experiments.paper.released_energy.figure import EXACT, STYLES, draw_curves
from experiments.paper.released_energy.fits import HEIGHTS, HIGH, LOW, column, exact_value
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

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
