"""asymmetry.png: the largest angle of the midpoint against the mismatch."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ...trends import saturating
from ..settings import RANGES

COLOURS = (palette.BEAM, palette.CENTRE, palette.FORCE)
LINES: tuple[Any, ...] = ("-", (0, (7, 1.2)), (0, (2.5, 0.9)))
MARKS = {"paper": "s", "undamped": "^", "reference": "o"}
HOLLOW = {"mfc": palette.PAPER, "ls": ""}
BOXES = (0.06, 0.2, 0.41, 0.69), (0.56, 0.2, 0.41, 0.69)

Sweeps = Mapping[str, Mapping[float, Sequence[Row]]]


def draw_asymmetry(
    sweeps: Sweeps, found: Mapping[float, Any], fitted_upto_rad: float, path: Path
) -> None:
    """Both axes linear on the left, logarithmic on the right; ``found``: laws at standard."""
    with panels(path, (12.5, 6.2), "Largest angle of the midpoint in a snap", *BOXES) as both:
        for axes, marked_from in zip(both, (fitted_upto_rad, 0.0), strict=True):
            _sweeps(axes, sweeps, 0.999 * marked_from)
            axes.set(xlabel="mismatch Δα (rad)", ylabel="θ$_{max}$ (rad)")
        left, right = both
        for colour, (epsilon, rows) in zip(COLOURS, sweeps["standard"].items(), strict=True):
            lags, tilts, rest = columns(rows)
            left.plot(lags, tilts - rest, color=colour, lw=1.3, ls="-.")
            left.text(0.35, tilts[-1] - 0.11, f"ε = {epsilon:g}", color=colour, ha="center")
        low, high = RANGES["delta_alpha_rad"]
        left.axvspan(low, high, color=palette.SHADE, lw=0, zorder=0)
        words = {"color": palette.QUIET, "ha": "center"}
        left.text(0.5 * (low + high), 0.04, "the paper's designs", **words)
        left.set(xlim=(-0.006, 0.41), ylim=(0.0, 1.4))
        lags = np.logspace(-6.0, np.log10(fitted_upto_rad), 200)
        for colour, one in zip(COLOURS, found.values(), strict=True):
            tilts = saturating(lags, one.slope, one.threshold_rad)
            right.plot(lags, tilts, color=palette.INK, lw=0.9, zorder=6)
            level = one.level_rad / np.sqrt(2.0)
            right.plot([one.threshold_rad], [level], "D", ms=9, mew=2.0, mec=colour, zorder=8,
                       **HOLLOW)  # fmt: skip
        right.set(xscale="log", yscale="log", xlim=(8e-7, 0.5), ylim=(3e-4, 2.0))
        _key(left.figure, found)


def columns(rows: Sequence[Row]) -> list[Any]:
    """Mismatches, largest angles and angles at rest of the snaps."""
    snapped = [row for row in rows if row["theta_max_rad"] is not None]
    keys = ("delta_alpha_rad", "theta_max_rad", "theta_rest_rad")
    return [column(snapped, key) for key in keys]


def _sweeps(axes: Any, sweeps: Sweeps, marked_from: float) -> None:
    """Lines at standard, marks at the other settings from a mismatch on."""
    for setting, by_epsilon in sweeps.items():
        for colour, line, rows in zip(COLOURS, LINES, by_epsilon.values(), strict=True):
            lags, tilts, _ = columns(rows)
            if setting == "standard":
                axes.plot(lags, tilts, color=colour, ls=line, lw=2.4, zorder=4)
            else:
                shown = lags >= marked_from
                axes.plot(lags[shown], tilts[shown], color=colour, marker=MARKS[setting], ms=5.5,
                          mew=1.3, zorder=5, **HOLLOW)  # fmt: skip


def _key(figure: Any, epsilons: Iterable[float]) -> None:
    """One legend below both."""
    from matplotlib.lines import Line2D

    def key(label: str, **style: Any) -> Any:
        return Line2D([], [], label=label, **style)

    figure.legend(
        handles=[
            *(
                key(f"ε = {epsilon:g}, standard", color=colour, ls=line, lw=2.4)
                for colour, line, epsilon in zip(COLOURS, LINES, epsilons, strict=True)
            ),
            *(
                key(setting, color=palette.INK, marker=mark, mew=1.3, **HOLLOW)
                for setting, mark in MARKS.items()
            ),
            key("less the tilt at rest", color=palette.QUIET, lw=1.3, ls="-."),
            key("law", color=palette.INK, lw=0.9),
            key("threshold", color=palette.QUIET, marker="D", ms=9, mew=2.0, **HOLLOW),
        ],
        loc="lower center",
        ncols=5,
    )
