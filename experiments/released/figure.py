"""released.png: ours against theirs, and the differences against the four parameters."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.designs import COLUMNS, LABELS
from snapjump.plots import palette
from snapjump.plots.saving import picture

BOUNDS = {"x": 15.0, "y": 6.0}  # percent that the axes show; what is beyond lies on the edge


def draw_comparison(rows: Sequence[dict[str, Any]], path: Path) -> None:
    """Two squares of apexes above eight small pictures of differences."""
    known = [row for row in rows if row["y_difference_percent"] is not None]
    values = {key: np.array([float(row[key]) for row in known]) for key in _columns()}
    with picture(path, (12.0, 10.0), "The released program's data, at its settings") as figure:
        for k, name in enumerate(("x", "y")):
            axes = figure.add_axes((0.09 + 0.5 * k, 0.56, 0.38, 0.34))
            theirs, ours = values[f"{name}_released_bar"], values[f"{name}_bar"]
            top = 1.05 * max(theirs.max(), ours.max())
            low = min(0.0, theirs.min(), ours.min())
            axes.plot([low, top], [low, top], color=palette.INK, lw=1)
            axes.plot(theirs, ours, "o", ms=4, alpha=0.6, mec="none", color=palette.BEAM)
            axes.set(xlabel=f"{name} of the apex, theirs (L)", ylabel=f"{name}, ours (L)")
            axes.grid(True)
            for j, parameter in enumerate(COLUMNS):
                _differences(figure, values, name, parameter, (j, k))


def _columns() -> list[str]:
    kinds = ("bar", "released_bar", "difference_percent")
    return [*COLUMNS, *(f"{name}_{kind}" for name in ("x", "y") for kind in kinds)]


def _differences(
    figure: Any, values: dict[str, Any], name: str, parameter: str, place: tuple[int, int]
) -> None:
    """Differences of one coordinate against one parameter."""
    column, row = place
    bound = BOUNDS[name]
    axes = figure.add_axes((0.09 + 0.235 * column, 0.305 - 0.225 * row, 0.175, 0.17))
    shown = np.clip(values[f"{name}_difference_percent"], -bound, bound)
    axes.axhline(0.0, color=palette.INK, lw=1)
    axes.plot(values[parameter], shown, "o", ms=3, alpha=0.6, mec="none", color=palette.CLAMP)
    axes.set_ylim(-1.05 * bound, 1.05 * bound)
    axes.grid(True)
    if row == 1:
        axes.set_xlabel(LABELS[parameter])
    if column == 0:
        axes.set_ylabel(f"{name}, ours less theirs (%)")
