"""Scatter of the apex by tolerances, of a robust design and of a plain one."""

from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.targets.designed import Designed
from snapjump.targets.robust import Scatter

PLAIN, ROBUST = palette.CLAMP, palette.BEAM
SHOWN = 0.995  # of the samples, in the limits of either axis


def both(designed: Designed) -> list[tuple[str, Scatter, str]]:
    """The plain design's distribution and the robust one's."""
    assert designed.robust is not None
    return [
        ("plain", designed.robust.plain_scatter, PLAIN),
        ("robust", designed.robust.robust_scatter, ROBUST),
    ]


def draw_scatter(axes: Any, designed: Designed) -> None:
    """Both clouds of apexes, their means, and the circles that hold 90 % about the target."""
    from matplotlib.patches import Circle

    target = designed.problem.target
    for name, found, colour in both(designed):
        axes.plot(*found.apexes.T, ".", ms=2.5, color=colour, alpha=0.45, zorder=3)
        axes.plot(*found.mean, "o", ms=8, color=colour, mec=palette.INK, zorder=6, label=name)
        radius = found.radius90_bar
        axes.add_patch(
            Circle(tuple(target), radius, fill=False, ec=colour, lw=1.6, ls="--", zorder=5)
        )
    axes.plot(*target, "+", ms=17, mew=2.0, color=palette.INK, zorder=7, label="target")
    apexes = np.vstack([found.apexes for _, found, _ in both(designed)])
    away = np.quantile(np.abs(apexes - target).max(axis=1), SHOWN)
    widest = max(float(away), *(found.radius90_bar for _, found, _ in both(designed)))
    axes.set(xlabel="x / L", ylabel="y / L", ylim=target[1] + 1.05 * widest * np.array([-1.0, 1.0]))
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True)
    axes.legend(loc="upper left", title="apexes within tolerances\n(dashed: 90 % of them)")


def draw_misses(axes: Any, designed: Designed) -> None:
    """Share of the robots that come within a distance of the target."""
    for name, found, colour in both(designed):
        misses = np.sort(np.hypot(*(found.apexes - designed.problem.target).T))
        share = 100.0 * np.arange(1, len(misses) + 1) / len(misses)
        mean = found.expected_miss_bar
        axes.plot(misses, share, color=colour, lw=2.2, label=f"{name}: {mean:.3g} L expected")
        axes.plot([mean] * 2, [0.0, 100.0], color=colour, lw=1.2, ls=":")
    axes.axhline(90.0, color=palette.QUIET, lw=0.8, ls="--")
    axes.set(
        xlabel="distance from the target / L", ylabel="share of the robots (%)",
        xlim=(0.0, None), ylim=(0.0, 100.0),
    )  # fmt: skip
    axes.grid(True)
    axes.legend(loc="lower right")
