"""A filmstrip: the robot at chosen instants, all panels at one scale, on one set of axes in L."""

from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.instants import instants, travel
from snapjump.show.plots.motion import Array, Motion, poses
from snapjump.show.plots.robot_drawing import arrows, draw_forces, draw_ground, draw_robot

GHOSTS = 5
ROWS = COLUMNS = 3  # of panels
ARROW = 0.18  # length in L of the largest force
STRAINED: Any = {"marker": "D", "ms": 7.0, "color": palette.PLUM, "mec": palette.PAPER, "lw": 0}
Window = tuple[float, float, float, float]  # x, y, width, height in L


def draw_filmstrip(
    figure: Any, motion: Motion, liftoff_ms: float | None, box: tuple[float, float, float, float]
) -> None:
    """Fill `box` (left, bottom, width, height of the figure) with panels and one key."""
    chosen = instants(motion, liftoff_ms, ROWS * COLUMNS - 1)
    axes = figure.add_axes(box)
    axes.set_axis_off()
    tall = box[3] * figure.get_figheight() / ROWS
    wide = box[2] * figure.get_figwidth() / COLUMNS
    window = _window(motion, np.array([index for index, _ in chosen]), 0.96 * wide / (0.86 * tall))
    cell = window[2] / 0.96, window[3] / 0.86
    axes.set(xlim=(0.0, COLUMNS * cell[0]), ylim=(-ROWS * cell[1], 0.0))
    largest = float(motion.push.max(initial=0.0))
    before = 0
    for place, (index, name) in enumerate(chosen):
        row, column = divmod(place, COLUMNS)
        left, top = column * cell[0], -row * cell[1] - 0.12 * cell[1]
        shift = left - window[0], top - window[3] - window[1]
        _draw_panel(axes, motion, before, index, window, shift, largest)
        label = {"va": "bottom", "transform": axes.transData}
        axes.text(left, top + 0.015 * cell[1], name, **label)
        clock = f"{motion.time[index]:.2f} ms"
        right = left + window[2]
        axes.text(right, top + 0.015 * cell[1], clock, ha="right", weight="bold", **label)
        before = index
    row, column = divmod(ROWS * COLUMNS - 1, COLUMNS)
    corner = column * cell[0] + 0.06 * cell[0], -row * cell[1] - 0.12 * cell[1]
    _draw_key(axes, motion, largest > 0.0, corner, window)


def _window(motion: Motion, chosen: Array, aspect: float) -> Window:
    """The part of the world that every panel shows: it holds every instant chosen."""
    x, y = np.moveaxis(motion.outline()[chosen], -1, 0)
    left, right, low, high = x.min() - 0.1, x.max() + 0.1, y.min() - 0.1, y.max() + 0.08
    if motion.centre is not None:
        low = min(low, -ARROW - 0.05)
    width = max(right - left, aspect * (high - low))
    extra = width / aspect - (high - low)
    return 0.5 * (left + right - width), low - 0.3 * extra, width, width / aspect


def _draw_panel(
    axes: Any,
    motion: Motion,
    before: int,
    index: int,
    window: Window,
    shift: tuple[float, float],
    largest: float,
) -> None:
    """One instant, over pale traces of the beam since the instant `before`, moved by `shift`."""
    left, low, width, height = window
    dx, dy = shift
    sides, shade = [left + dx, left + dx + width], {"color": palette.SHADE, "lw": 0, "zorder": 0}
    axes.fill_between(sides, low + dy, low + dy + height, **shade)
    if motion.centre is not None:
        draw_ground(axes, (low + dy, dy), *sides)
    if index > before + 1:
        style = {"color": palette.SKY, "lw": 0.9, "alpha": 0.6, "zorder": 2}
        axes.plot(*(_ghosts(motion, before, index) + shift).T, **style)
    draw_robot(axes, motion, index, shift)
    if motion.centre is not None:
        axes.plot(*(motion.centre[index] + shift), "o", ms=6, color=palette.CENTRE, zorder=6)
    bent = motion.bent
    if bent is not None and index == bent.sample:
        axes.plot(*(motion.nodes[index, bent.node] + shift), **STRAINED, zorder=8)
        told = f"strain {100.0 * bent.strain:.2f} % at {bent.place:.2f} L"
        place = left + dx + 0.03 * width, low + dy + 0.97 * height
        axes.text(*place, told, color=palette.PLUM, va="top")
    push = motion.push[index]
    if largest > 0.0 and push > 0.05:
        foot = np.column_stack([motion.pad_x[index], np.zeros_like(motion.pad_x[index])])
        draw_forces(axes, foot + shift, ARROW * arrows(motion, index))
        strongest = motion.pad_x[index, np.argmax(motion.pad_force[index, :, 1])]
        aside, part = ("left", 0.03) if strongest > left + 0.5 * width else ("right", 0.97)
        size = f"{push:.1f} × weight" if push < 10 else f"{push:.0f} × weight"
        place = left + dx + part * width, low + dy + 0.03 * height
        axes.text(*place, size, color=palette.FORCE, ha=aside, va="bottom")


def _ghosts(motion: Motion, before: int, index: int) -> Array:
    """Beams (P, 2) evenly spread over the way between two samples, parted by NaN."""
    path = travel(motion)[before : index + 1]
    marks = np.linspace(path[0], path[-1], GHOSTS + 1)[:-1]
    ghosts = poses(motion, np.interp(marks, path, motion.time[before : index + 1]))
    return np.hstack([ghosts.nodes, np.full((len(marks), 1, 2), np.nan)]).reshape(-1, 2)


def _draw_key(
    axes: Any, motion: Motion, forces: bool, corner: tuple[float, float], window: Window
) -> None:
    """A key to the colours, and a scale bar, in the last cell (upper left corner given)."""
    entries: list[tuple[str, dict[str, Any]]] = [
        ("beam", {"color": palette.BEAM, "lw": 2.4}),
        ("beam in between", {"color": palette.SKY, "lw": 1.0}),
        ("clamp", {"color": palette.CLAMP, "lw": 5.0, "solid_capstyle": "butt"}),
    ]
    if motion.corners is not None:
        entries.insert(0, ("rigid frame", {"color": palette.FRAME, "lw": 2.8}))
    if motion.centre is not None:
        entries.append(("centre of mass", {"color": palette.CENTRE, "marker": "o", "lw": 0}))
    if forces:
        entries.append(("push of the ground (√)", {"color": palette.FORCE, "lw": 2.4}))
    if motion.bent is not None:
        entries.append(("largest strain of the beam", STRAINED))
    for name, style in entries:
        axes.plot([], [], label=name, **style)
    axes.legend(
        loc="upper left", bbox_to_anchor=corner, bbox_transform=axes.transData,
        borderaxespad=0.0, handlelength=1.7, labelspacing=0.55,
    )  # fmt: skip
    bar = 0.5 if window[2] < 3.0 else 1.0
    x, y = corner[0], corner[1] - 0.97 * window[3]
    axes.plot([x, x + bar], [y, y], color=palette.INK, lw=2.0, solid_capstyle="butt")
    size = f"{bar:g} L = {1e3 * bar * motion.length_m:.3g} mm"
    axes.text(x + bar + 0.05 * window[2], y, size, va="center")
