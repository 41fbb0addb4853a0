"""bounce.png and slide.png: where one node goes, and what the ground does to it."""

import pathlib
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.jump import headline
from snapjump.show.plots.motion import Motion
from snapjump.show.plots.saving import picture

# Label of an axis, and its curves: array, colour, name in the legend.
GROUND = {
    "speed (m/s)": (("node_vx_m_s", palette.CLAMP, "along"), ("node_vy_m_s", palette.CENTRE, "up")),
    "force (N)": (
        ("node_normal_N", palette.FORCE, "normal"),
        ("node_friction_N", palette.VIOLET, "friction"),
    ),
}


def point_picture(result: Any, motion: Motion, path: pathlib.Path) -> None:
    """Position along and above the ground, speed, and the ground's forces, against time."""
    x, y = motion.nodes[:, 0].T
    rows: list[tuple[str, list[tuple[Any, str, str]]]] = []
    for label, column in (("x / L", x), ("height y / L", y)):
        if np.ptp(column) > 1e-9:
            rows.append((label, [(column, palette.BEAM, "")]))
    for label, known in GROUND.items():
        curves = [
            (np.asarray(result.arrays[name]).reshape(-1), colour, text)
            for name, colour, text in known
            if np.size(result.arrays.get(name, ())) == motion.count and np.any(result.arrays[name])
        ]
        if curves:
            rows.append((label, curves))
    rows = rows or [("height y / L", [(y, palette.BEAM, "")])]
    with picture(path, (10.0, 8.0), headline(result)) as figure:
        height = 0.87 / len(rows)
        for place, (label, curves) in enumerate(rows):
            axes = figure.add_axes((0.09, 0.94 - (place + 1) * height, 0.89, 0.86 * height))
            for values, colour, name in curves:
                axes.plot(motion.time, values, color=colour, lw=2.0, label=name)
            last = max(motion.time[-1], motion.time[0] + 1e-9)
            axes.set(ylabel=label, xlim=(motion.time[0], last))
            axes.grid(True)
            if curves[0][2]:
                axes.legend(loc="best")
            if place < len(rows) - 1:
                axes.tick_params(labelbottom=False)
        axes.set_xlabel("time from the start (ms)")
