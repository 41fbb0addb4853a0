"""snaps.png: shapes of the two snaps, and height and tilt of the midpoint."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.plots import palette
from snapjump.plots.robot_drawing import clamp_stubs
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

LINES = {
    "standard": (palette.BEAM, "-", 2.4),
    "undamped": (palette.CENTRE, "--", 1.8),
    "paper": (palette.FORCE, ":", 2.2),
}
CLOSE_UP_MS = (-1.6, 1.0)  # about the crossing at standard
TINTS = "viridis"
KEYS = (("height_bar", "midpoint height / L"), ("tangent_rad", "midpoint tilt (rad)"))


def draw_snaps(motions: Mapping[str, Sequence[Row]], exact: Sequence[Row], path: Path) -> None:
    """A column for each mismatch: shapes, heights, tilts."""
    lags = sorted({row["delta_alpha_rad"] for row in motions["standard"]})
    title = "The snap with equal clamps and with a mismatch"
    with picture(path, (12.0, 9.6), title) as figure:
        for column, lag in enumerate(lags):
            left = 0.075 + 0.485 * column
            curves = {name: of(motions[name], "sample", lag) for name in LINES}
            shapes = of(motions["standard"], "shape", lag)
            zero = crossing_ms(curves["standard"])
            _shapes(figure.add_axes((left, 0.635, 0.42, 0.28)), shapes, lag, zero)
            for place, (key, label) in enumerate(KEYS):
                axes = figure.add_axes((left, 0.35 - 0.285 * place, 0.42, 0.235))
                _motion(axes, curves, key, zero)
                _instants(axes, curves["standard"], shapes, key, zero)
                _independent(axes, exact, lag, key, zero)
                axes.set(xlim=CLOSE_UP_MS, ylim=((-0.235, 0.19), (-0.75, 0.75))[place])
                axes.set_ylabel(label)
                axes.grid(True)
                axes.axhline(0.0, color=palette.QUIET, lw=0.8, zorder=1)
                if place == 1:
                    axes.set_xlabel("time from the crossing at standard (ms)")
                    axes.legend(loc="lower left")


def of(rows: Sequence[Row], kind: str, lag: float) -> list[Row]:
    """Rows of a kind and a mismatch."""
    return [row for row in rows if row["kind"] == kind and row["delta_alpha_rad"] == lag]


def values(rows: Sequence[Row], key: str) -> NDArray[np.float64]:
    """A column."""
    return np.array([row[key] for row in rows], dtype=float)


def crossing_ms(rows: Sequence[Row]) -> float:
    """When the midpoint crosses the line of the clamps, after the start."""
    height, time = values(rows, "height_bar"), values(rows, "time_ms")
    k = int(np.flatnonzero(height < 0.0)[0])
    return float(np.interp(0.0, -height[k - 1 : k + 1], time[k - 1 : k + 1]))


def tints(count: int) -> list[Any]:
    """Colours of so many shapes, in the order of time; the palest are left out."""
    import matplotlib

    return [matplotlib.colormaps[TINTS](0.88 * k / max(count - 1, 1)) for k in range(count)]


def number(axes: Any, x: float, y: float, k: int, colour: Any) -> None:
    """The number of a shape."""
    disc = {"boxstyle": "circle,pad=0.18", "fc": palette.PAPER, "ec": colour, "lw": 1.4}
    axes.text(x, y, str(k), fontsize=8.5, ha="center", va="center", bbox=disc, zorder=9)


def _shapes(axes: Any, shapes: Sequence[Row], lag: float, zero: float) -> None:
    """The beam at the instants, coloured by time."""
    for k, (row, colour) in enumerate(zip(shapes, tints(len(shapes)), strict=True), 1):
        x, y = np.array(row["x_bar"]), np.array(row["y_bar"])
        axes.plot(x, y, color=colour, lw=2.2, zorder=5)
        if k in (1, len(shapes)):
            axes.plot(*clamp_stubs(x, y, 0.035), color=palette.CLAMP, lw=4.5, zorder=4)
        middle = len(x) // 2
        number(axes, x[middle], y[middle], k, colour)
    axes.set_title(
        f"Δα = {lag:g} rad: 1 at rest, {zero - shapes[0]['time_ms']:.1f} ms before the crossing",
        loc="left",
    )
    axes.set(xlim=(-0.52, 0.52), ylim=(-0.25, 0.24), xlabel="x / L", ylabel="y / L")
    axes.set_aspect("equal", adjustable="box", anchor="C")


def _motion(axes: Any, curves: Mapping[str, Sequence[Row]], key: str, zero: float) -> None:
    for name, rows in curves.items():
        colour, line, width = LINES[name]
        time = values(rows, "time_ms") - zero
        axes.plot(time, values(rows, key), color=colour, ls=line, lw=width, label=name, zorder=3)


def _instants(
    axes: Any, curve: Sequence[Row], shapes: Sequence[Row], key: str, zero: float
) -> None:
    """The shapes on the curve at standard: numbers on the height, dots on the tilt."""
    time, along = values(curve, "time_ms"), values(curve, key)
    for k, (row, colour) in enumerate(zip(shapes, tints(len(shapes)), strict=True), 1):
        moment = row["time_ms"]
        if not CLOSE_UP_MS[0] < moment - zero < CLOSE_UP_MS[1]:
            continue
        value = float(np.interp(moment, time, along))
        if key == "height_bar":
            number(axes, moment - zero, value, k, colour)
        else:
            axes.plot([moment - zero], [value], "o", ms=6.5, mfc=palette.PAPER, mec=colour, mew=1.6,
                      zorder=8)  # fmt: skip


def _independent(axes: Any, exact: Sequence[Row], lag: float, key: str, zero: float) -> None:
    """The crossing by the independent solution."""
    row = max((row for row in exact if row["delta_alpha_rad"] == lag), key=lambda one: one["terms"])
    value = 0.0 if key == "height_bar" else row["tangent_crossing_rad"]
    axes.plot(
        [row["crossing_ms"] - zero], [value], "s", ms=8, mfc="none", mec=palette.INK, mew=1.6,
        zorder=8, label="independent, undamped",
    )  # fmt: skip
