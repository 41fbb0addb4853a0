"""Shapes of a beam at some instants, numbered and coloured in their order."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.robot_drawing import clamp_stubs


def tints(count: int) -> list[Any]:
    """Colours of so many shapes, in the order of time; the palest are left out."""
    import matplotlib

    return [matplotlib.colormaps["viridis"](0.88 * k / max(count - 1, 1)) for k in range(count)]


def number(axes: Any, x: float, y: float, k: int, colour: Any) -> None:
    """The number of a shape, on a disc."""
    disc = {"boxstyle": "circle,pad=0.18", "fc": palette.PAPER, "ec": colour, "lw": 1.4}
    axes.text(x, y, str(k), fontsize=8.5, ha="center", va="center", bbox=disc, zorder=9)


def draw_shapes(axes: Any, shapes: Sequence[tuple[Any, Any]]) -> None:
    """Beams (x, y) in L in the order of time, the first and the last with their clamps, numbers at
    their middles."""
    for k, ((x, y), colour) in enumerate(zip(shapes, tints(len(shapes)), strict=True), 1):
        x, y = np.asarray(x), np.asarray(y)
        axes.plot(x, y, color=colour, lw=2.2, zorder=5)
        if k in (1, len(shapes)):
            axes.plot(*clamp_stubs(x, y, 0.035), color=palette.CLAMP, lw=4.5, zorder=4)
        middle = len(x) // 2
        number(axes, x[middle], y[middle], k, colour)
    axes.set(xlabel="x / L", ylabel="y / L")
    axes.set_aspect("equal", adjustable="box", anchor="C")
