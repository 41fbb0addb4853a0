"""Work-precision diagrams: error and roughness against cost, a line for each composition."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path
from typing import Any

from snapjump.show.plots import palette
from snapjump.show.plots.saving import axes_at, picture

from .points import Point, pareto

COSTS = {"ms": "ms a jump (median, one core)", "newton_iterations": "Newton iterations a jump"}
ERRORS_P95 = {
    "x_p95_percent": "error of x (%), 95th percentile",
    "y_p95_percent": "error of y (%), 95th percentile",
    "x_roughness_bar": "roughness of x (L)",
}
ERRORS_MEDIAN = {
    "x_median_percent": "error of x (%), median",
    "y_median_percent": "error of y (%), median",
    "y_roughness_bar": "roughness of y (L)",
}
# Of lines, by what follows the method in a curve's name; of all other curves.
LOOKS = {
    "adaptive": {"ls": "-", "lw": 1.6, "alpha": 0.9},
    "fixed": {"ls": "--", "lw": 1.6, "alpha": 0.9},
}
OTHER = {"ls": ":", "lw": 0.9, "alpha": 0.6}
FRONT = {"color": palette.INK, "lw": 5.0, "alpha": 0.18}
TIER = {"color": palette.INK, "marker": "*"}
FAILED = {"color": "#c1121f", "marker": "x", "ms": 8, "mew": 2}
PANEL = (6.0, 4.0)  # inches
SIDE, TOP, FOOT = 2.6, 0.6, 0.35
# Larger errors (%) and roughness (L) are no answers any more, and are drawn like failures.
LARGEST = {"percent": 100.0, "bar": 1.0}


@dataclass(frozen=True)
class Compared:
    """Points, curves and tiers to draw; ``methods``: by curve, what it is coloured by."""

    points: Sequence[Point]
    methods: Mapping[str, str]
    tiers: Mapping[str, Point]

    @property
    def colours(self) -> dict[str, str]:
        names = dict.fromkeys(self.methods.values())
        return dict(zip(names, cycle(palette.SERIES), strict=False))


def draw_precision(
    compared: Compared, errors: Mapping[str, str], headline: str, path: Path
) -> None:
    """Rows of errors, columns of costs."""
    wide, high = PANEL
    size = (wide * len(COSTS) + SIDE, high * len(errors) + TOP + FOOT)
    with picture(path, size, headline) as figure:
        for r, (error, error_label) in enumerate(errors.items()):
            for c, (cost, cost_label) in enumerate(COSTS.items()):
                bottom = (len(errors) - 1 - r) * high + 0.65 + FOOT
                axes = axes_at(figure, c * wide + 0.85, bottom, wide - 1.0, high - 0.85)
                _panel(axes, compared, cost, error)
                axes.set(xlabel=cost_label, ylabel=error_label)
        place = (1.0 - (SIDE - 0.1) / size[0], 1.0 - TOP / size[1])
        handles = _handles(compared.colours)
        figure.legend(handles=handles, loc="upper left", bbox_to_anchor=place)


def _panel(axes: Any, compared: Compared, cost: str, error: str) -> None:
    def place(points: Sequence[Point]) -> tuple[list[float], list[float]]:
        return [getattr(p, cost) for p in points], [getattr(p, error) for p in points]

    axes.set(xscale="log", yscale="log")
    axes.grid(True)
    for curve, method in compared.methods.items():
        good = [p for p in compared.points if p.curve == curve and drawable(p, cost, error)]
        look = LOOKS.get(curve.removeprefix(f"{method} "), OTHER)
        axes.plot(*place(good), marker="o", ms=2.5, color=compared.colours[method], **look)
    sound = [p for p in compared.points if p.failed == 0]
    axes.plot(*place([sound[k] for k in pareto(*place(sound))]), zorder=1, **FRONT)
    _failures(axes, compared.points, cost, error)
    backdrop = {"fc": palette.PAPER, "ec": "none", "alpha": 0.75, "pad": 0.8}
    for name, point in compared.tiers.items():
        if drawable(point, cost, error):
            axes.plot(*place([point]), ms=14, mec=palette.PAPER, zorder=6, **TIER)
            axes.annotate(name, (getattr(point, cost), getattr(point, error)), xytext=(8, 7),
                          textcoords="offset points", fontweight="bold", zorder=7,
                          bbox=backdrop)  # fmt: skip


def _failures(axes: Any, points: Sequence[Point], cost: str, error: str) -> None:
    """A cross where jumps failed: at the error if it is known in spite of them, else at the top."""
    for p in points:
        spent = getattr(p, cost)
        if p.failed and drawable(p, cost, error):
            axes.plot(spent, getattr(p, error), zorder=5, **FAILED)
        elif p.jumps and not drawable(p, cost, error) and math.isfinite(spent):
            axes.plot(spent, 0.975, transform=axes.get_xaxis_transform(), zorder=5, **FAILED)


def drawable(point: Point, cost: str, error: str) -> bool:
    """Whether a point has a place on logarithmic axes."""
    spent, value = getattr(point, cost), getattr(point, error)
    # An infinite or unknown error is not below the largest either.
    return math.isfinite(spent) and spent > 0.0 and 0.0 < value <= LARGEST[error.split("_")[-1]]


def _handles(colours: Mapping[str, str]) -> list[Any]:
    from matplotlib.lines import Line2D

    entries: dict[str, dict[str, Any]] = {
        **{name: {"color": colour, "lw": 2.5} for name, colour in colours.items()},
        "adaptive steps": {"color": palette.QUIET, "lw": 1.6, "ls": "-"},
        "fixed steps": {"color": palette.QUIET, "lw": 1.6, "ls": "--"},
        "variants (see table)": {"color": palette.QUIET, "lw": 0.9, "ls": ":"},
        "Pareto front": FRONT,
        "tiers": {**TIER, "ms": 12, "ls": ""},
        "jumps failed, or\nerror above 100 % (1 L)": {**FAILED, "ls": ""},
    }
    return [Line2D([], [], label=label, **look) for label, look in entries.items()]
