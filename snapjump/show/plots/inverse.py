"""inverse.png: what can be reached, the target, its designs, and the jump of the chosen one."""

from pathlib import Path
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.achievable import draw_map, draw_region
from snapjump.show.plots.jump import apex_of, milliseconds
from snapjump.show.plots.motion import Motion, poses, read_motion
from snapjump.show.plots.saving import picture
from snapjump.show.plots.scatter import draw_misses, draw_scatter
from snapjump.show.plots.trajectory import draw_trajectory, flight_end
from snapjump.targets.designed import Designed
from snapjump.targets.region import AchievableRegion

WIDTH, HEIGHT, MORE = 15.0, 6.6, 5.2  # inches; MORE: of the row for a robust design
SAMPLES = 80


def inverse_picture(designed: Designed, region: AchievableRegion | None, path: Path) -> Path:
    """Region and trajectory, the misses of all designs, the flight to scale; for a robust design
    the distributions of the apex. Without a region (no forward model) only what was simulated."""
    high = HEIGHT if designed.robust is None else HEIGHT + MORE
    with picture(path, (WIDTH, high), headline(designed)) as figure:
        top, size = 1.0 - 1.15 / high, (HEIGHT - 1.9) / high
        axes = figure.add_axes((0.05, top - size, 0.36, size))
        if region is not None:
            draw_region(axes, region)
            draw_map(figure, (0.475, top - size, 0.22, size), designed, region)
        motion = read_motion(designed.jump)
        if motion is not None and motion.centre is not None:
            draw_path(axes, designed, motion)
            left = 0.8 if region is not None else 0.475
            flight = figure.add_axes((left, top - size, 0.99 - left, size))
            draw_trajectory(
                flight, motion, milliseconds(designed.jump, "apex_time_s"), apex_of(designed.jump)
            )
        mark(axes, designed)
        axes.set(xlabel="x / L", ylabel="y / L", ylim=(0.0, None))
        axes.grid(True)
        axes.legend(
            loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, borderaxespad=0.2, borderpad=0.0,
            handlelength=1.8, columnspacing=1.2,
        )  # fmt: skip
        if designed.robust is not None:
            row = (MORE - 1.2) / high
            draw_scatter(figure.add_axes((0.05, 0.6 / high, 0.36, row)), designed)
            draw_misses(figure.add_axes((0.475, 0.6 / high, 0.36, row)), designed)
    return path


def headline(designed: Designed) -> str:
    """Target, environment and design in one line."""
    problem = designed.problem
    x, y = problem.target.tolist()
    delta_alpha, epsilon = designed.chosen.controls.tolist()
    title = f"Target ({x:g}, {y:g}) L at μ = {problem.mu:g}, m\u0304 = {problem.mass_bar:g}:  "
    found = f"Δα = {delta_alpha:.4g} rad,  ε = {epsilon:.4g}"
    if designed.answer.reachable:
        return title + found
    return f"{title}not reached; nearest {found}"


def draw_path(axes: Any, designed: Designed, motion: Motion) -> None:
    """The simulated path of the centre of mass, from the ground to the apex."""
    assert motion.centre is not None
    end = flight_end(motion, milliseconds(designed.jump, "apex_time_s"))
    flight = poses(motion, np.linspace(motion.time[-1], end, SAMPLES))
    assert flight.centre is not None
    path = np.vstack([motion.centre, flight.centre])
    axes.plot(*path.T, color=palette.CENTRE, lw=1.8, zorder=6, label="simulated path")


def mark(axes: Any, designed: Designed) -> None:
    """Target, predicted and simulated apex; the last two fall on the first if all is well."""
    if designed.simulated is not None:
        axes.plot(
            *designed.simulated, "*", ms=15, color=palette.FORCE, mec=palette.PAPER, zorder=8,
            label="simulated apex",
        )  # fmt: skip
    if designed.predicted is not None:
        axes.plot(
            *designed.predicted, "o", ms=9, mfc="none", mec=palette.PLUM, mew=1.6, zorder=9,
            label="predicted apex",
        )  # fmt: skip
    axes.plot(
        *designed.problem.target, "+", ms=17, mew=2.0, color=palette.INK, zorder=10, label="target"
    )
