"""snap_imperfections.png: how small a mismatch breaks the symmetry, at several rates."""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from experiments.paper.snap_settings import RATE_RAD_S
from experiments.paper.snaps.judge import SET_BY_HAND_RAD, VISIBLE_RAD
from experiments.paper.snaps.setting import EPSILON
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

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
