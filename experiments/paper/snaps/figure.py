"""snaps.png: two snaps; snap_imperfections.png: how small a mismatch is seen."""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from experiments.paper.settings import RATE_RAD_S
from experiments.paper.snaps.judge import EPSILON, SET_BY_HAND_RAD, VISIBLE_RAD
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.robot_drawing import clamp_stubs
from snapjump.show.plots.saving import picture

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


STYLES = {
    ("standard", 200.0): (palette.SKY, "-", "^"),
    ("standard", RATE_RAD_S): (palette.BEAM, "-", "o"),
    ("undamped", RATE_RAD_S): (palette.CENTRE, "--", "D"),
    ("paper", RATE_RAD_S): (palette.FORCE, ":", "s"),
    ("standard", 2.0): (palette.PLUM, "-", "v"),
    ("standard", 0.2): (palette.CLAMP, "-", "P"),
}
NONE_AT = 1e-9  # where equal clamps are drawn
LOWEST = 1e-15  # rad: what is below is drawn there


def draw_imperfections(tiny: Mapping[tuple[str, float], Sequence[Row]], path: Path) -> None:
    """Largest tilt against mismatch, both logarithmic."""
    title = f"How small a mismatch makes the snap asymmetric (ε = {EPSILON:g})"
    with picture(path, (10.0, 5.6), title) as figure:
        axes = figure.add_axes((0.09, 0.12, 0.62, 0.77))
        for key, (colour, line, mark) in STYLES.items():
            snapped = [row for row in tiny[key] if row["theta_max_rad"] is not None]
            lags = np.array([row["delta_alpha_rad"] for row in snapped])
            tilts = np.array([max(row["theta_max_rad"], LOWEST) for row in snapped])
            style = {"color": colour, "ms": 6.5, "mec": palette.PAPER, "mew": 0.6, "clip_on": False}
            some = lags > 0.0
            label = f"{key[1]:g} rad/s, {key[0]}"
            axes.plot(lags[some], tilts[some], mark + line, lw=1.8, label=label, **style)
            axes.plot([NONE_AT] * len(tilts[~some]), tilts[~some], mark, **style)
        axes.axhline(VISIBLE_RAD, color=palette.QUIET, lw=1.0, ls="-.")
        axes.text(1.3 * NONE_AT, 1.5 * VISIBLE_RAD, "one degree", color=palette.QUIET)
        axes.axvspan(1e-9, SET_BY_HAND_RAD, color=palette.SHADE, lw=0, zorder=0)
        words = f"clamps equal within {math.degrees(SET_BY_HAND_RAD):.1g}°"
        axes.text(0.8 * SET_BY_HAND_RAD, 3.0 * LOWEST, words, ha="right", color=palette.QUIET)
        axes.set(xscale="log", yscale="log", xlim=(NONE_AT, 0.15), ylim=(LOWEST, 5.0))
        ticks = [10.0**k for k in range(-8, 0)]
        axes.set_xticks([NONE_AT, *ticks], ["equal", *(f"$10^{{{k}}}$" for k in range(-8, 0))])
        axes.set(xlabel="mismatch Δα (rad)", ylabel="largest tilt θ$_{max}$ (rad)")
        axes.grid(True)
        axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))
