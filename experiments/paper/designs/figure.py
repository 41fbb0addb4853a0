"""designs.png: flights to targets; designs_misses.png: how far off they are."""

from collections.abc import Mapping, Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.robot.robot import Robot
from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.robot_drawing import draw_ground
from snapjump.show.plots.saving import panels

from ...inverse_benchmark.methods import PAPER
from ..settings import TIERS

COLOURS = (palette.BEAM, palette.FORCE, palette.CENTRE, palette.PLUM, palette.CLAMP,
           palette.VIOLET, palette.SKY, palette.QUIET)  # fmt: skip
MARKERS = {"adam": ("s", palette.QUIET), "gauss_newton": ("o", palette.BEAM),
           "physics": ("^", palette.CENTRE)}  # fmt: skip
POINTS = 60
PAST = 0.35  # of the rise's time, that flights are drawn for past their apex


def draw_flights(groups: Mapping[str, Sequence[Row]], path: Path) -> None:
    """One robot on the left, many on the right."""
    title = "Designed jumps, simulated: the paths of the centre of mass"
    boxes = [(0.05 + 0.49 * k, 0.08, 0.44, 0.8) for k in range(len(groups))]
    with panels(path, (14.0, 8.0), title, *boxes) as sides:
        for axes, (group, rows) in zip(sides, groups.items(), strict=True):
            axes.set_title(f"{group}, {len(rows)} targets", loc="left")
            named = len({row["mass_bar"] for row in rows}) > 1
            for row, colour in zip(rows, cycle(COLOURS), strict=False):
                others = [other for other in rows if target_of(other) == target_of(row)]
                # Jumps to one apex share their parabola: the first is the wide one.
                width = 1.8 if row is others[-1] else 5.0
                draw_flight(axes, row, colour, width)
                if row is others[0]:
                    tell(axes, others)
                if named:
                    text = f"{row['robot']}: m̄ = {row['mass_bar']:g}, μ = {row['mu']:g}"
                    axes.plot([], [], color=colour, lw=width, label=text)
            if named:
                axes.legend(loc="upper right", ncols=2)
            right, top = (max(row[f"target_{axis}_bar"] for row in rows) for axis in "xy")
            axes.set(xlabel="x / L", ylabel="y / L", xlim=(-0.03 * right, 1.3 * right))
            axes.set_ylim(-0.04 * top, (1.35 if named else 1.12) * top)
            draw_ground(axes, (-0.04 * top, 0.0), *axes.get_xlim())


def target_of(row: Row) -> tuple[float, float]:
    """The target x, y in L."""
    return row["target_x_bar"], row["target_y_bar"]


def tell(axes: Any, rows: Sequence[Row]) -> None:
    """Name the robots above their common target."""
    box = {"facecolor": palette.PAPER, "edgecolor": "none", "alpha": 0.8, "pad": 1.0}
    axes.annotate(
        ", ".join(row["robot"] for row in rows), target_of(rows[0]), (0, 12),
        textcoords="offset points", ha="center", zorder=8, bbox=box,
    )  # fmt: skip


def draw_flight(axes: Any, row: Row, colour: str, width: float) -> None:
    """A parabola through lift-off and apex, the apex, and the target."""
    if row["standard_x_bar"] is not None:
        rise, fall = flight(row)
        axes.plot(*rise, color=colour, lw=width)
        axes.plot(*fall, color=colour, lw=0.7 * width, ls=(0, (4, 3)))
        axes.plot(row["standard_x_bar"], row["standard_y_bar"], "o", ms=7, mfc="none", mec=colour)
    axes.plot(*target_of(row), "+", ms=15, mew=1.8, color=palette.INK, zorder=9)


def flight(row: Row) -> tuple[Any, Any]:
    """Path (2, K) from lift-off to the apex, and that past it, in L."""
    robot = Robot()
    speed = row["liftoff_vx_m_s"] / robot.length_m
    x, y = row["standard_x_bar"], row["standard_y_bar"]
    duration = np.sqrt(2.0 * (y - row["liftoff_y_bar"]) * robot.length_m / robot.gravity_m_s2)

    def at(time: Any) -> Any:
        height = y - 0.5 * robot.gravity_m_s2 / robot.length_m * time**2
        return np.array([x + speed * time, height])

    return at(np.linspace(-duration, 0.0, POINTS)), at(np.linspace(0.0, PAST * duration, POINTS))


def draw_misses(methods: Mapping[str, Sequence[Row]], path: Path) -> None:
    """Misses of every target by method and tier, on a logarithmic axis."""
    title = "Misses of the designs, judged at three tiers"
    boxes = [(0.07 + 0.315 * k, 0.14, 0.275, 0.62) for k in range(len(TIERS))]
    names = [row["robot"] for row in next(iter(methods.values()))]
    with panels(path, (12.0, 5.0), title, *boxes) as sides:
        for tier, axes in zip(TIERS, sides, strict=True):
            axes.set_title(f"judged at {tier}", loc="left")
            for name, rows in methods.items():
                marker, colour = MARKERS[name]
                axes.plot(column(rows, f"miss_{tier}_mm"), marker, ms=7, mfc="none", mec=colour,
                          mew=1.5, label=name)  # fmt: skip
            axes.axhline(float(str(PAPER[0]["mean_mm"])), color=palette.INK, lw=1.0, ls=":")
            axes.set(yscale="log", ylim=(2e-4, 200.0))
            axes.set_xticks(range(len(names)), names, rotation=90)
        sides[0].set_ylabel("miss (mm)")
        sides[0].legend(loc="lower left", bbox_to_anchor=(0.0, 1.08), ncols=3)
