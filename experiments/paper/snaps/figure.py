"""snaps.png: two snaps; snap_imperfections.png: how small a mismatch is seen."""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels
from snapjump.show.plots.shapes import draw_shapes, number, tints

from ...arches.swings import RATE_RAD_S
from ...styles import boxes
from ..limits import LIMITS

SNAPS, TINY = (12.0, 9.6), (10.0, 5.6)
LINES = {
    "standard": (palette.BEAM, "-", 2.4),
    "undamped": (palette.CENTRE, "--", 1.8),
    "paper": (palette.FORCE, ":", 2.2),
}
CLOSE_UP_MS = (-1.6, 1.0)  # about the crossing at standard
# What is drawn against time, and its range.
KEYS = {
    "height_bar": ("midpoint height / L", (-0.235, 0.19)),
    "tangent_rad": ("midpoint tilt (rad)", (-0.75, 0.75)),
}


def draw_snaps(motions: Mapping[str, Sequence[Row]], exact: Sequence[Row], path: Path) -> None:
    """A column for each mismatch: shapes, heights, tilts; ``exact``: the independent solution, its
    best rows last."""
    lags = sorted({row["delta_alpha_rad"] for row in motions["standard"]})
    title = "The snap with equal clamps and with a mismatch"
    with panels(path, SNAPS, title, *boxes(SNAPS, 3, len(lags), across=0.85)) as drawn:
        for k, lag in enumerate(lags):
            curves = {name: of(motions[name], "sample", lag) for name in LINES}
            shapes = of(motions["standard"], "shape", lag)
            zero = crossing_ms(curves["standard"])
            before = zero - shapes[0]["time_ms"]
            drawn[k].set_title(
                f"Δα = {lag:g} rad: 1 at rest, {before:.1f} ms before the crossing", loc="left"
            )
            draw_shapes(drawn[k], [(row["x_bar"], row["y_bar"]) for row in shapes])
            drawn[k].set(xlim=(-0.52, 0.52), ylim=(-0.25, 0.24))
            drawn[k].grid(False)
            best = [row for row in exact if row["delta_alpha_rad"] == lag][-1]
            crossing = {"height_bar": 0.0, "tangent_rad": best["tangent_crossing_rad"]}
            lower = drawn[len(lags) + k :: len(lags)]
            for axes, (key, (label, limits)) in zip(lower, KEYS.items(), strict=True):
                for name, (colour, line, width) in LINES.items():
                    time, values = column(curves[name], "time_ms"), column(curves[name], key)
                    axes.plot(time - zero, values, color=colour, ls=line, lw=width, label=name)
                draw_instants(axes, curves["standard"], shapes, key, zero)
                axes.plot(best["crossing_ms"] - zero, crossing[key], "s", ms=8, mfc="none",
                          mec=palette.INK, mew=1.6, zorder=8,
                          label="independent, undamped")  # fmt: skip
                axes.axhline(0.0, color=palette.QUIET, lw=0.8, zorder=1)
                axes.set(xlim=CLOSE_UP_MS, ylim=limits, ylabel=label)
            axes.set_xlabel("time from the crossing at standard (ms)")
            axes.legend(loc="lower left")


def of(rows: Sequence[Row], kind: str, lag: float) -> list[Row]:
    """Rows of a kind and a mismatch."""
    return [row for row in rows if row["kind"] == kind and row["delta_alpha_rad"] == lag]


def crossing_ms(rows: Sequence[Row]) -> float:
    """When the midpoint crosses the line of the clamps, after the start."""
    height, time = column(rows, "height_bar"), column(rows, "time_ms")
    k = int(np.flatnonzero(height < 0.0)[0])
    return float(np.interp(0.0, -height[k - 1 : k + 1], time[k - 1 : k + 1]))


def draw_instants(
    axes: Any, curve: Sequence[Row], shapes: Sequence[Row], key: str, zero: float
) -> None:
    """The shapes on the curve at standard: numbers on the height, dots on the tilt."""
    time, along = column(curve, "time_ms"), column(curve, key)
    for k, (row, colour) in enumerate(zip(shapes, tints(len(shapes)), strict=True), 1):
        moment, value = row["time_ms"] - zero, float(np.interp(row["time_ms"], time, along))
        if not CLOSE_UP_MS[0] < moment < CLOSE_UP_MS[1]:
            continue
        if key == "height_bar":
            number(axes, moment, value, k, colour)
        else:
            axes.plot([moment], [value], "o", ms=6.5, mfc=palette.PAPER, mec=colour, mew=1.6,
                      zorder=8)  # fmt: skip


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


def draw_tiny(tiny: Mapping[tuple[str, float], Sequence[Row]], epsilon: float, path: Path) -> None:
    """Largest tilt against mismatch, both logarithmic."""
    title = f"How small a mismatch makes the snap asymmetric (ε = {epsilon:g})"
    visible = LIMITS["snaps.symmetry.mismatched"].confirmed
    by_hand = LIMITS["snaps.symmetry.mismatch"].confirmed
    with panels(path, TINY, title, *boxes(TINY, 1, 1, left=0.9, right=2.9)) as (axes,):
        for key, (colour, line, mark) in STYLES.items():
            snapped = [row for row in tiny[key] if row["theta_max_rad"] is not None]
            lags = column(snapped, "delta_alpha_rad")
            tilts = np.maximum(column(snapped, "theta_max_rad"), LOWEST)
            style = {"color": colour, "ms": 6.5, "mec": palette.PAPER, "mew": 0.6, "clip_on": False}
            some = lags > 0.0
            label = f"{key[1]:g} rad/s, {key[0]}"
            axes.plot(lags[some], tilts[some], mark + line, lw=1.8, label=label, **style)
            axes.plot([NONE_AT] * len(tilts[~some]), tilts[~some], mark, **style)
        axes.axhline(visible, color=palette.QUIET, lw=1.0, ls="-.")
        axes.text(1.3 * NONE_AT, 1.5 * visible, "one degree", color=palette.QUIET)
        axes.axvspan(1e-9, by_hand, color=palette.SHADE, lw=0, zorder=0)
        words = f"clamps equal within {math.degrees(by_hand):.1g}°"
        axes.text(0.8 * by_hand, 3.0 * LOWEST, words, ha="right", color=palette.QUIET)
        axes.set(xscale="log", yscale="log", xlim=(NONE_AT, 0.15), ylim=(LOWEST, 5.0))
        ticks = [10.0**k for k in range(-8, 0)]
        axes.set_xticks([NONE_AT, *ticks], ["equal", *(f"$10^{{{k}}}$" for k in range(-8, 0))])
        axes.set(xlabel="mismatch Δα (rad)", ylabel="largest tilt θ$_{max}$ (rad)")
        axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))
