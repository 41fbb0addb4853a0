"""static.png and cantilever.png: equilibria along the clamp angle, their energy and shapes."""

import pathlib
from collections.abc import Iterator
from itertools import cycle
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

STABLE: Any = {"color": palette.BEAM, "lw": 2.4, "zorder": 3}
UNSTABLE: Any = {"color": palette.FORCE, "lw": 1.7, "ls": (0, (3, 2))}
CURVES = {
    "branch_midpoint_bar": "height of the middle, y / L",
    "branch_energy_bar": "elastic energy (EI/L)",
}
SHAPE_COLOURS = (palette.BEAM, palette.FORCE, palette.CENTRE, palette.CLAMP, palette.VIOLET)


def branches_picture(
    arrays: dict[str, Any], headline: str, critical_rad: float | None, path: pathlib.Path
) -> None:
    """Draw those of the three panels that there are arrays for.

    ``branch_*`` are 1-D, ``branch_number`` telling which branch a point belongs to;
    ``shapes_*_bar`` are (S, N+1) in L.
    """
    curves = [item for item in CURVES.items() if item[0] in arrays]
    with picture(path, (12.0, 6.5), headline) as figure:
        for place, (name, label) in enumerate(curves):
            box = (0.07, 0.11, 0.40, 0.76) if place == 0 else (0.57, 0.57, 0.41, 0.30)
            axes = figure.add_axes(box)
            _draw_branches(axes, arrays, arrays[name], critical_rad, legend=place == 0)
            axes.set_ylabel(label)
        if "shapes_x_bar" in arrays:
            box = (0.57, 0.11, 0.41, 0.33) if curves else (0.07, 0.11, 0.9, 0.76)
            _draw_shapes(figure.add_axes(box), arrays)


def stable_runs(number: Any, negative: Any) -> Iterator[tuple[slice, bool]]:
    """Pieces of equal stability of each branch; each reaches the branch's next point."""
    stable = np.asarray(negative) == 0
    start = 0
    for end in range(1, len(number) + 1):
        over = end == len(number) or number[end] != number[start]
        if over or stable[end] != stable[start]:
            yield slice(start, end + (not over)), bool(stable[start])
            start = end


def _draw_branches(
    axes: Any, arrays: dict[str, Any], values: Any, critical_rad: float | None, legend: bool
) -> None:
    """Solid where no pivot is negative (stable), dashed where one is."""
    alpha = arrays["branch_alpha_rad"]
    for piece, stable in stable_runs(arrays["branch_number"], arrays["branch_negative_pivots"]):
        axes.plot(alpha[piece], values[piece], **(STABLE if stable else UNSTABLE))
    axes.grid(True)
    axes.set_xlabel("clamp angle α (rad)")
    if critical_rad is not None:
        axes.axvline(critical_rad, color=palette.QUIET, lw=1.0, zorder=1)
    if legend:
        axes.plot([], [], label="stable", **STABLE)
        axes.plot([], [], label="unstable", **UNSTABLE)
        if critical_rad is not None:
            label = f"critical, {critical_rad:.6f} rad"
            axes.plot([], [], color=palette.QUIET, lw=1.0, label=label)
        axes.legend(
            loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, borderaxespad=0.3,
            columnspacing=1.2, handlelength=1.6,
        )  # fmt: skip


def _draw_shapes(axes: Any, arrays: dict[str, Any]) -> None:
    """Shapes of the beam, to scale."""
    x, y, labels = (arrays[f"shapes_{name}"] for name in ("x_bar", "y_bar", "label"))
    for *shape, label, colour in zip(x, y, labels, cycle(SHAPE_COLOURS), strict=False):
        axes.plot(*shape, color=colour, lw=2.2, label=str(label))
    ends = x[:, [0, -1]].ravel(), y[:, [0, -1]].ravel()
    axes.plot(*ends, "o", ms=4, mfc=palette.PAPER, mec=palette.INK)
    axes.set(xlabel="x / L", ylabel="y / L")
    axes.grid(True)
    _leave_room(axes, x, y)
    axes.legend(loc="upper right")


def _leave_room(axes: Any, x: Any, y: Any) -> None:
    """Equal scales, the shapes on the left, and room on their right for the legend."""
    box = axes.get_window_extent()
    low, high = np.nanmin(y) - 0.05, np.nanmax(y) + 0.05
    left, right = np.nanmin(x) - 0.08, np.nanmax(x) + 0.08
    width = max(1.7 * (right - left), (high - low) * box.width / box.height)
    extra = width * box.height / box.width - (high - low)
    axes.set(xlim=(left, left + width), ylim=(low - 0.5 * extra, high + 0.5 * extra))
