"""Work-precision diagrams: error and roughness against cost, a line for each composition."""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from experiments.tradeoff.points import Point, pareto
from snapjump.plots import palette
from snapjump.plots.saving import picture

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
COLOURS = (
    palette.BEAM,
    palette.CENTRE,
    palette.FORCE,
    palette.PLUM,
    palette.CLAMP,
    palette.SKY,
    palette.VIOLET,
    palette.FRAME,
    "#8c510a",
    "#01665e",
    "#4d9221",
    "#999999",
)
VARIANTS = {"adaptive": "-", "fixed": "--"}
OTHER = ":"
PANEL = (6.0, 4.0)  # inches
SIDE, TOP, FOOT = 2.6, 0.6, 0.35
# Larger errors (%) and roughness (L) are no answers any more, and are drawn like failures.
LARGEST = {"percent": 100.0, "bar": 1.0}
TIER_COLOUR = palette.INK
FAILED_COLOUR = "#c1121f"


def draw_precision(
    points: Sequence[Point],
    methods: Mapping[str, str],
    tiers: Mapping[str, Point],
    errors: Mapping[str, str],
    headline: str,
    path: Path,
) -> None:
    """Rows of errors, columns of costs; ``methods``: by curve, what it is coloured by."""
    rows, columns = len(errors), len(COSTS)
    size = (PANEL[0] * columns + SIDE, PANEL[1] * rows + TOP + FOOT)
    names = list(dict.fromkeys(methods.values()))
    colours = {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(names)}
    with picture(path, size, headline) as figure:
        for r, (error, error_label) in enumerate(errors.items()):
            for c, (cost, cost_label) in enumerate(COSTS.items()):
                left = (c * PANEL[0] + 0.85) / size[0]
                bottom = ((rows - 1 - r) * PANEL[1] + 0.65 + FOOT) / size[1]
                box = (left, bottom, (PANEL[0] - 1.0) / size[0], (PANEL[1] - 0.85) / size[1])
                axes = figure.add_axes(box)
                _panel(axes, points, methods, colours, tiers, cost, error)
                axes.set_xlabel(cost_label)
                axes.set_ylabel(error_label)
        _legend(figure, colours, size)


def _panel(
    axes: Any,
    points: Sequence[Point],
    methods: Mapping[str, str],
    colours: Mapping[str, str],
    tiers: Mapping[str, Point],
    cost: str,
    error: str,
) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True)
    for curve, method in methods.items():
        own = [p for p in points if p.curve == curve]
        good = [p for p in own if drawable(p, cost, error)]
        variant = curve.removeprefix(f"{method} ")
        axes.plot(
            [getattr(p, cost) for p in good],
            [getattr(p, error) for p in good],
            VARIANTS.get(variant, OTHER),
            marker="o",
            ms=2.5,
            lw=1.6 if variant in VARIANTS else 0.9,
            color=colours[method],
            alpha=0.9 if variant in VARIANTS else 0.6,
        )
    sound = [p for p in points if p.failed == 0]
    front = pareto([getattr(p, cost) for p in sound], [getattr(p, error) for p in sound])
    axes.plot(
        [getattr(sound[k], cost) for k in front],
        [getattr(sound[k], error) for k in front],
        color=palette.INK,
        lw=5.0,
        alpha=0.18,
        zorder=1,
    )
    _failures(axes, points, cost, error)
    for name, point in tiers.items():
        if drawable(point, cost, error):
            place = (getattr(point, cost), getattr(point, error))
            axes.plot(*place, "*", ms=14, color=TIER_COLOUR, mec=palette.PAPER, zorder=6)
            axes.annotate(
                name,
                place,
                xytext=(8, 7),
                textcoords="offset points",
                fontweight="bold",
                zorder=7,
                bbox={"fc": palette.PAPER, "ec": "none", "alpha": 0.75, "pad": 0.8},
            )


def _failures(axes: Any, points: Sequence[Point], cost: str, error: str) -> None:
    """A cross where jumps failed: at the error if it is known in spite of them, else at the top."""
    look = {"marker": "x", "ms": 8, "mew": 2, "color": FAILED_COLOUR, "zorder": 5}
    for p in points:
        spent = getattr(p, cost)
        if p.failed and drawable(p, cost, error):
            axes.plot(spent, getattr(p, error), **look)
        elif p.jumps and not drawable(p, cost, error) and math.isfinite(spent):
            axes.plot(spent, 0.975, transform=axes.get_xaxis_transform(), **look)


def drawable(point: Point, cost: str, error: str) -> bool:
    """Whether a point has a place on logarithmic axes."""
    spent, value = getattr(point, cost), getattr(point, error)
    # An infinite or unknown error is not below the largest either.
    return math.isfinite(spent) and spent > 0.0 and 0.0 < value <= LARGEST[error.split("_")[-1]]


def _legend(figure: Any, colours: Mapping[str, str], size: tuple[float, float]) -> None:
    from matplotlib.lines import Line2D

    handles = [Line2D([], [], color=c, lw=2.5, label=name) for name, c in colours.items()]
    ink = palette.QUIET
    handles += [
        Line2D([], [], color=ink, lw=1.6, ls="-", label="adaptive steps"),
        Line2D([], [], color=ink, lw=1.6, ls="--", label="fixed steps"),
        Line2D([], [], color=ink, lw=0.9, ls=":", label="variants (see table)"),
        Line2D([], [], color=palette.INK, lw=5, alpha=0.18, label="Pareto front"),
        Line2D([], [], color=TIER_COLOUR, marker="*", ms=12, ls="", label="tiers"),
        Line2D(
            [],
            [],
            color=FAILED_COLOUR,
            marker="x",
            ms=8,
            mew=2,
            ls="",
            label="jumps failed, or\nerror above 100 % (1 L)",
        ),
    ]
    figure.legend(
        handles=handles,
        loc="upper left",
        bbox_to_anchor=(1.0 - (SIDE - 0.1) / size[0], 1.0 - TOP / size[1]),
    )
