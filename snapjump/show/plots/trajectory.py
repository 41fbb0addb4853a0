"""The flight: the path of the centre of mass from the ground to its apex, to scale in L."""

from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.motion import Motion, Poses, poses
from snapjump.show.plots.robot_drawing import draw_ground, draw_robot

SPACING, MOST = 1.3, 7  # of the silhouettes: least distance in L, greatest number


def flight_end(motion: Motion, apex_ms: float | None) -> float:
    """When the picture of the flight ends (ms): at the apex, or with the last sample."""
    last = float(motion.time[-1])
    apex = last + motion.rise_ms if apex_ms is None else apex_ms
    return max(last, apex) if motion.rise_ms > 0.0 else last


def draw_trajectory(
    axes: Any, motion: Motion, apex_ms: float | None, apex: tuple[float, float] | None
) -> None:
    """Path of the centre of mass on `axes`, with the robot at several instants."""
    if motion.centre is None:
        axes.set_axis_off()
        return
    end = flight_end(motion, apex_ms)
    flight = poses(motion, np.linspace(motion.time[-1], end, 60))
    assert flight.centre is not None
    top = apex if apex is not None else tuple(motion.centre[np.argmax(motion.centre[:, 1])])
    shown = _silhouettes(motion, end)
    _limits(axes, shown, top)
    draw_ground(axes, (axes.get_ylim()[0], 0.0), *axes.get_xlim())
    for k in range(len(shown.time)):
        draw_robot(axes, shown, k, scale=0.5, alpha=0.75)
    flies = end > motion.time[-1]
    axes.plot(
        *flight.centre.T, ls=(0, (4, 2.5)), lw=1.6, color=palette.CENTRE, alpha=0.75, zorder=7,
        label="centre of mass, in flight" if flies else None,
    )  # fmt: skip
    axes.plot(
        *motion.centre.T, lw=2.8, color=palette.CENTRE, zorder=8, label="centre of mass, simulated"
    )
    if apex is not None:
        _mark_apex(axes, apex, motion.length_m)
    axes.set(xlabel="x / L", ylabel="y / L", aspect="equal")
    axes.grid(True)
    axes.legend(
        loc="lower left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.2, borderpad=0.0,
        handlelength=2.2, labelspacing=0.25,
    )  # fmt: skip


def _silhouettes(motion: Motion, end: float) -> Poses:
    """The robot at the start and at instants evenly spread in height, so that none overlap."""
    last = float(motion.time[-1])
    rise = 0.5 * motion.gravity * (end - last) ** 2
    part = np.linspace(0.0, 1.0, int(np.clip(rise / SPACING, 1, MOST)) + 1)
    times = last + (1.0 - np.sqrt(1.0 - part)) * (end - last)  # slowed by gravity
    return poses(motion, np.concatenate([[0.0], times[1:] if end > last else [last]]))


def _limits(axes: Any, shown: Poses, top: Any) -> None:
    """Limits that hold the silhouettes and the apex label, in the axes' own proportions."""
    x, y = np.moveaxis(shown.outline(), -1, 0)
    low_x, high_x = min(x.min(), top[0]), max(x.max(), top[0])
    high_y = max(y.max(), top[1], 2.0)
    margin = 0.06 * max(high_y, high_x - low_x) + 0.1
    box = axes.get_window_extent()
    aspect = box.width / box.height
    low, high = -margin, high_y + 1.5 * margin
    width = max(high_x - low_x + 2.0 * margin, aspect * (high - low))
    high = max(high, low + width / aspect)
    middle = 0.5 * (low_x + high_x)
    axes.set(xlim=(middle - 0.5 * width, middle + 0.5 * width), ylim=(low, high))


def _mark_apex(axes: Any, apex: tuple[float, float], length_m: float) -> None:
    """A star at the apex with its coordinates in L and mm, on the side that has more room."""
    axes.plot(*apex, "*", ms=15, color=palette.FORCE, mec=palette.PAPER, zorder=9)
    left, right = axes.get_xlim()
    roomy_left = apex[0] - left > right - apex[0]
    size = 1e3 * length_m
    axes.annotate(
        f"apex ({apex[0]:.2f}, {apex[1]:.2f}) L\n({apex[0] * size:.1f}, {apex[1] * size:.1f}) mm",
        apex,
        xytext=(-16 if roomy_left else 16, 0),
        textcoords="offset points",
        ha="right" if roomy_left else "left",
        va="center",
        zorder=10,
        bbox={"facecolor": palette.PAPER, "edgecolor": "none", "alpha": 0.7, "pad": 1.0},
    )
