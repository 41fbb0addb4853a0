"""A robot drawn on matplotlib axes: frame, clamps, beam, ground, forces. Units of L."""

from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.motion import Array, Motion, Poses


def draw_ground(axes: Any, levels: tuple[float, float], left: float, right: float) -> None:
    """Ground between two `levels`, the upper one its surface."""
    axes.fill_between([left, right], *levels, color=palette.GROUND, lw=0, zorder=0.5)
    axes.plot([left, right], [levels[1]] * 2, color=palette.INK, lw=1.2, zorder=1)


def clamp_stubs(x: Array, y: Array, size: float) -> tuple[Array, Array]:
    """Short bars along the beam's end tangents, (3, 2): left, gap (NaN), right; x and y alike."""
    if len(x) < 3:
        return np.full(1, np.nan), np.full(1, np.nan)
    angle = np.unwrap(np.arctan2(np.diff(y), np.diff(x)))
    first = angle[0] - 0.5 * (angle[1] - angle[0])
    last = angle[-1] + 0.5 * (angle[-1] - angle[-2])
    ends, angles = [0, 0, 0, -1, -1], np.array([first, first, np.nan, last, last])
    along = size * np.array([-1.0, 1.0, np.nan, -1.0, 1.0])
    return x[ends] + along * np.cos(angles), y[ends] + along * np.sin(angles)


def draw_robot(
    axes: Any,
    shown: Poses,
    k: int,
    shift: tuple[float, float] = (0.0, 0.0),
    *,
    scale: float = 1.0,
    alpha: float = 1.0,
) -> None:
    """Beam and frame of a pose, moved by `shift`; `scale` multiplies the line widths."""
    if shown.corners is not None:
        frame = {"solid_joinstyle": "miter", "solid_capstyle": "butt", "zorder": 3}
        corners = (shown.corners[k] + shift).T
        axes.plot(*corners, color=palette.FRAME, lw=2.6 * scale, alpha=alpha, **frame)
    x, y = (shown.nodes[k] + shift).T
    axes.plot(x, y, color=palette.BEAM, lw=2.2 * scale, alpha=alpha, zorder=5)
    if scale >= 0.6:
        bars = clamp_stubs(x, y, 0.05)
        axes.plot(*bars, color=palette.CLAMP, lw=5.0 * scale, solid_capstyle="butt", zorder=4)
        ends = {"ms": 4.2 * scale, "mfc": palette.PAPER, "mec": palette.INK, "zorder": 6}
        axes.plot(x[[0, -1]], y[[0, -1]], "o", **ends)


def arrows(motion: Motion, sample: int) -> Array:
    """Forces of the ground (P, 2) as arrows; their lengths go as the root, the largest push's is 1.
    A strike pushes some hundred times harder than the robot's weight: the root shows both."""
    force = motion.pad_force[sample]
    size = np.hypot(*force.T)[:, None]
    return force / np.sqrt(np.maximum(size, 1e-12) * max(float(motion.push.max()), 1e-12))


def draw_forces(axes: Any, foot: Array, vector: Array) -> None:
    """Arrows (P, 2) in L that end at `foot` (P, 2)."""
    seen = np.hypot(*vector.T) > 5e-3
    if not seen.any():
        return
    vector = vector[seen]
    axes.quiver(
        *(foot[seen] - vector).T, *vector.T, color=palette.FORCE, angles="xy", scale_units="xy",
        scale=1.0, units="inches", width=0.03, headlength=4.0, headaxislength=3.6, zorder=7,
    )  # fmt: skip
