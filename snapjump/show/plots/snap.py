"""snap.png: a filmstrip of the snap, and the motion of the beam's middle."""

import pathlib
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.show.plots import palette
from snapjump.show.plots.filmstrip import draw_filmstrip
from snapjump.show.plots.instants import middle_height, settled, snap_interval
from snapjump.show.plots.jump import headline
from snapjump.show.plots.motion import Motion
from snapjump.show.plots.saving import picture


def _close_up(motion: Motion) -> tuple[float, float]:
    """From a little before the snap until the beam has come to rest (ms); else the whole run."""
    snap = snap_interval(motion)
    if snap is None:
        return float(motion.time[0]), max(float(motion.time[-1]), float(motion.time[0]) + 1e-9)
    begin, end = float(motion.time[snap[0]]), float(motion.time[settled(motion)])
    return max(begin - 0.3 * (end - begin), float(motion.time[0])), max(end, begin + 1e-9)


def snap_picture(result: Any, motion: Motion, path: pathlib.Path) -> None:
    """Filmstrip on the left; height and angle of the middle against time on the right."""
    with picture(path, (12.0, 8.0), headline(result)) as figure:
        draw_filmstrip(figure, motion, None, (0.015, 0.02, 0.60, 0.91))
        curves = (
            ("height of the middle over the clamps, y / L", middle_height(motion), palette.BEAM),
            (
                "tangent angle at the middle (rad)",
                middle_angle(*np.moveaxis(motion.nodes, -1, 0)),
                palette.VIOLET,
            ),
        )
        for place, (label, values, colour) in enumerate(curves):
            axes = figure.add_axes((0.685, 0.53 - 0.455 * place, 0.3, 0.36))
            axes.plot(motion.time, values, color=colour, lw=2.2)
            axes.set_title(label, loc="left")
            axes.grid(True)
            axes.axhline(0.0, color=palette.QUIET, lw=0.8, zorder=1)
            axes.set_xlim(*_close_up(motion))
            if place == 1:
                axes.set_xlabel("time from the start (ms)")


def middle_angle(x: Array, y: Array) -> Array:
    """Tangent angle (S) at the midpoint of nodes (S, N + 1): over the two elements that meet there,
    or over the middle one of an odd number."""
    last = y.shape[1] - 1
    before, after = (last + 1) // 2 - 1, last // 2 + 1
    return np.asarray(np.arctan2(y[:, after] - y[:, before], x[:, after] - x[:, before]))
