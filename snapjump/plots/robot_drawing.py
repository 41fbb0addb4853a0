"""A robot drawn on matplotlib axes: frame, clamps, beam, ground, forces. Units of L."""

from typing import Any

import numpy as np

from snapjump.plots import palette
from snapjump.plots.motion import Array, Motion


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
    bars_x = [x[0] - size * np.cos(first), x[0] + size * np.cos(first), np.nan]
    bars_y = [y[0] - size * np.sin(first), y[0] + size * np.sin(first), np.nan]
    bars_x += [x[-1] - size * np.cos(last), x[-1] + size * np.cos(last)]
    bars_y += [y[-1] - size * np.sin(last), y[-1] + size * np.sin(last)]
    return np.array(bars_x), np.array(bars_y)


def draw_robot(
    axes: Any,
    x: Array,
    y: Array,
    corners: tuple[Array, Array] | None,
    *,
    scale: float = 1.0,
    alpha: float = 1.0,
) -> None:
    """Beam nodes (N+1,), frame outline (4,) or None; `scale` multiplies the line widths."""
    if corners is not None:
        axes.plot(
            *corners,
            color=palette.FRAME,
            lw=2.6 * scale,
            alpha=alpha,
            solid_joinstyle="miter",
            solid_capstyle="butt",
            zorder=3,
        )
    axes.plot(x, y, color=palette.BEAM, lw=2.2 * scale, alpha=alpha, zorder=5)
    if scale >= 0.6:
        bars = clamp_stubs(x, y, 0.05)
        axes.plot(*bars, color=palette.CLAMP, lw=5.0 * scale, solid_capstyle="butt", zorder=4)
        axes.plot(
            x[[0, -1]],
            y[[0, -1]],
            "o",
            ms=4.2 * scale,
            mfc=palette.PAPER,
            mec=palette.INK,
            zorder=6,
        )


def arrows(motion: Motion, sample: int) -> Array:
    """Forces of the ground (P, 2) as arrows; their lengths go as the root, the largest push's is 1.

    A strike pushes some hundred times harder than the robot's weight: the root shows both.
    """
    force = motion.pad_force[sample]
    size = np.hypot(force[:, 0], force[:, 1])[:, None]
    return force / np.sqrt(np.maximum(size, 1e-12) * max(float(motion.push.max()), 1e-12))


def draw_forces(axes: Any, foot: tuple[Array, Array], vector: Array) -> None:
    """Arrows (P, 2) in L that end at `foot`, x and y (P,)."""
    seen = np.hypot(vector[:, 0], vector[:, 1]) > 5e-3
    if not seen.any():
        return
    vector = vector[seen]
    axes.quiver(
        foot[0][seen] - vector[:, 0],
        foot[1][seen] - vector[:, 1],
        *vector.T,
        color=palette.FORCE,
        angles="xy",
        scale_units="xy",
        scale=1.0,
        units="inches",
        width=0.03,
        headlength=4.0,
        headaxislength=3.6,
        zorder=7,
    )
