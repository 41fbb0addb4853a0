"""released_energy.png, released_heights.png: what the snap releases, and the arch's depths."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ...arches import exact
from ...arches.critical import exact_points, within
from ...styles import DASHES, DOTS, boxes
from ...trends import straight_line
from ..settings import LABELS

Curves = Mapping[float, Sequence[Row]]  # by mismatch
ENERGY, HEIGHTS = (12.5, 4.8), (12.5, 8.4)
KEY = "energy_released_bar"
STYLES: tuple[dict[str, Any], ...] = (
    {"color": palette.BEAM, "lw": 2.2},
    {"color": palette.CENTRE, "lw": 2.2, "ls": DASHES},
    {"color": palette.FORCE, "lw": 2.2, "ls": DOTS},
)
EXACT: dict[str, Any] = {"marker": "o", "ls": "", "ms": 6, "mfc": "none", "mec": palette.INK,
                         "zorder": 5}  # fmt: skip
PROGRAM = {"color": palette.INK, "lw": 1.3, "label": "released program"}
OWN = {"color": palette.CLAMP, "marker": "s", "ms": 5, "lw": 1.0, "zorder": 4,
       "label": "two fixed nodes, Δα = 0"}  # fmt: skip
DEPTHS = {
    "h1": "depth of the lowest point at the snap, h1 / L",
    "h2": "depth of the snapped arch's middle, h2 / L",
}


def draw_curves(axes: Any, curves: Curves, key: str, against: Any) -> None:
    """A number of the rows against epsilon, with exact ones; ``against(epsilon, values)``: what is
    drawn of them."""
    for (delta_alpha, rows), style in zip(curves.items(), STYLES, strict=True):
        epsilon, values = column(rows, "epsilon"), column(rows, key)
        axes.plot(epsilon, against(epsilon, values), **style, label=f"Δα = {delta_alpha:g} rad")
        places, known = (np.array(one) for one in exact_points(rows, key))
        axes.plot(places, against(places, known), **EXACT)
    axes.plot([], [], **EXACT, label="exact")
    axes.set(xlim=(0.0, 0.31), xlabel=LABELS["epsilon"])


def itself(epsilon: Any, values: Any) -> Any:
    """The values."""
    return values


def draw_energy(curves: Curves, path: Path) -> None:
    """Energy with its line, deviation from lines, and energy over epsilon."""
    places = boxes(ENERGY, 1, 3, top=0.7, across=0.85)
    alike, ends = curves[0.0], np.array([0.0, 0.3])
    fits = {
        words: (column(rows, "epsilon"), column(rows, KEY))
        for words, rows in (("ε 0.1 to 0.3", within(alike)), ("all ε", alike))
    }
    lines = {words: straight_line(*fit) for words, fit in fits.items()}
    with panels(path, ENERGY, "Elastic energy released by the snap", *places) as drawn:
        energy, deviation, ratio = drawn
        draw_curves(energy, curves, KEY, itself)
        energy.plot(ends, lines["ε 0.1 to 0.3"].at(ends), color=palette.INK, lw=0.9, zorder=4,
                    label="best line, ε from 0.1")  # fmt: skip
        energy.legend(loc="upper left")
        two = (STYLES[0], {**STYLES[1], "color": palette.PLUM})
        for (words, (epsilon, values)), style in zip(fits.items(), two, strict=True):
            deviation.plot(epsilon, 100.0 * (1.0 - lines[words].at(epsilon) / values), **style,
                           label=f"from the best line for {words}")  # fmt: skip
        deviation.axhline(0.0, color=palette.QUIET, lw=0.8)
        deviation.set(xlim=(0.0, 0.31), xlabel=LABELS["epsilon"], ylim=(-8.0, 8.0))
        draw_curves(ratio, curves, KEY, lambda epsilon, values: values / epsilon)
        slope = exact.shallow()["E_over_eps_released"]
        ratio.axhline(slope, color=palette.QUIET, lw=1.2, ls=":", label="shallow limit, Δα = 0")
        ratio.set_ylim(0.4 * slope, 1.15 * slope)
        for axes in (deviation, ratio):
            axes.legend(loc="lower right")
        labels = ("released energy (EI/L)", "released energy less the line (% of it)",
                  "released energy / ε (EI/L)")  # fmt: skip
        for axes, label in zip(drawn, labels, strict=True):
            axes.set_ylabel(label)


def draw_heights(curves: Curves, own_mesh: Sequence[Row], path: Path) -> None:
    """Both depths; and all of them against the converged ones of clamps that turn alike."""
    title = "Depths of the arch, and the released program's polynomials"
    places = boxes(HEIGHTS, 2, 2, top=0.7, across=0.95, up=0.75)
    epsilon = column(within(curves[0.0]), "epsilon")
    with panels(path, HEIGHTS, title, *places) as drawn:
        for (name, label), depth, differences in zip(
            DEPTHS.items(), drawn[:2], drawn[2:], strict=True
        ):
            key = f"{name}_bar"
            converged = {row["epsilon"]: row[key] for row in curves[0.0]}

            def percent(places: Any, values: Any, converged: Any = converged) -> Any:
                return 100.0 * (values / np.array([converged[e] for e in places]) - 1.0)

            for axes, against in ((depth, itself), (differences, percent)):
                draw_curves(axes, curves, key, against)
                axes.plot(
                    epsilon, against(epsilon, exact.released_height(name, epsilon)), **PROGRAM
                )
                own = column(own_mesh, "epsilon")
                axes.plot(own, against(own, column(own_mesh, key)), **OWN)
            depth.set_ylabel(label)
            depth.legend(loc="lower right")
            differences.set_ylabel(f"{name} differs from converged, Δα = 0, by (%)")
