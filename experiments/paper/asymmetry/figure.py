"""asymmetry.png: the largest angle of the midpoint against the mismatch."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper.asymmetry.judge import FITTED_UPTO_RAD, Saturation, law
from experiments.paper.settings import RANGES
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

COLOURS = (palette.BEAM, palette.CENTRE, palette.FORCE)
LINES: tuple[Any, ...] = ("-", (0, (7, 1.2)), (0, (2.5, 0.9)))
MARKS = {"paper": "s", "undamped": "^", "reference": "o"}
LOWEST_RAD = 3e-4

Sweeps = Mapping[str, Mapping[float, Sequence[Row]]]


def draw_asymmetry(sweeps: Sweeps, found: Mapping[float, Saturation], path: Path) -> None:
    """Both axes linear on the left, logarithmic on the right."""
    with picture(path, (12.5, 6.2), "Largest angle of the midpoint in a snap") as figure:
        left = figure.add_axes((0.06, 0.2, 0.41, 0.69))
        right = figure.add_axes((0.56, 0.2, 0.41, 0.69))
        for axes, marked_from in ((left, FITTED_UPTO_RAD), (right, 0.0)):
            _sweeps(axes, sweeps, 0.999 * marked_from)
            axes.set(xlabel="mismatch Δα (rad)", ylabel="θ$_{max}$ (rad)")
            axes.grid(True)
        for colour, (epsilon, rows) in zip(COLOURS, sweeps["standard"].items(), strict=True):
            lags, tilts, rest = columns(rows)
            left.plot(lags, tilts - rest, color=colour, lw=1.3, ls="-.")
            left.text(0.35, tilts[-1] - 0.11, f"ε = {epsilon:g}", color=colour, ha="center")
        low, high = RANGES["delta_alpha_rad"]
        left.axvspan(low, high, color=palette.SHADE, lw=0, zorder=0)
        words = {"color": palette.QUIET, "ha": "center"}
        left.text(0.5 * (low + high), 0.04, "the paper's designs", **words)
        left.set(xlim=(-0.006, 0.41), ylim=(0.0, 1.4))
        for colour, one in zip(COLOURS, found.values(), strict=True):
            lags = np.logspace(-6.0, np.log10(FITTED_UPTO_RAD), 200)
            right.plot(lags, law(lags, one.slope, one.threshold_rad), color=palette.INK, lw=0.9,
                       zorder=6)  # fmt: skip
            level = one.level_rad / np.sqrt(2.0)
            right.plot([one.threshold_rad], [level], "D", ms=9, mfc=palette.PAPER, mec=colour,
                       mew=2.0, zorder=8)  # fmt: skip
        right.set(xscale="log", yscale="log", xlim=(8e-7, 0.5), ylim=(LOWEST_RAD, 2.0))
        _key(figure, found)


def columns(rows: Sequence[Row]) -> tuple[Any, Any, Any]:
    """Mismatches, largest angles and angles at rest of the snaps."""
    snapped = [row for row in rows if row["theta_max_rad"] is not None]
    keys = ("delta_alpha_rad", "theta_max_rad", "theta_rest_rad")
    lags, tilts, rest = (np.array([row[key] for row in snapped]) for key in keys)
    return lags, tilts, rest


def _sweeps(axes: Any, sweeps: Sweeps, marked_from: float) -> None:
    """Lines at standard, marks at the other settings from a mismatch on."""
    for setting, by_epsilon in sweeps.items():
        for colour, line, rows in zip(COLOURS, LINES, by_epsilon.values(), strict=True):
            lags, tilts, _ = columns(rows)
            if setting == "standard":
                axes.plot(lags, tilts, color=colour, ls=line, lw=2.4, zorder=4)
            else:
                shown = lags >= marked_from
                axes.plot(lags[shown], tilts[shown], MARKS[setting], color=colour, ms=5.5,
                          mfc=palette.PAPER, mew=1.3, zorder=5)  # fmt: skip


def _key(figure: Any, epsilons: Iterable[float]) -> None:
    """One legend below both."""
    from matplotlib.lines import Line2D

    lines = [
        Line2D([], [], color=colour, ls=line, lw=2.4, label=f"ε = {epsilon:g}, standard")
        for colour, line, epsilon in zip(COLOURS, LINES, epsilons, strict=True)
    ]
    hollow = {"ls": "", "mfc": palette.PAPER}
    marks = [
        Line2D([], [], color=palette.INK, marker=mark, mew=1.3, label=setting, **hollow)
        for setting, mark in MARKS.items()
    ]
    rest = Line2D([], [], color=palette.QUIET, lw=1.3, ls="-.", label="less the tilt at rest")
    fitted = Line2D([], [], color=palette.INK, lw=0.9, label="law")
    corner = Line2D([], [], color=palette.QUIET, marker="D", ms=9, mew=2.0, label="threshold",
                    **hollow)  # fmt: skip
    figure.legend(handles=[*lines, *marks, rest, fitted, corner], loc="lower center", ncols=5)
