"""regions.png and regions_settings.png: outlines of achievable regions."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.achievable import compound
from snapjump.show.plots.saving import panels

from ...styles import SERIES, boxes, legend_above

TITLE = "Achievable regions of simulated robots (filled) and by the forward model (dashed)"
REGIONS, SETTINGS = (15.0, 6.4), (15.0, 5.2)


def draw_regions(masses: Sequence[Any], frictions: Sequence[Any], path: Path) -> None:
    """Masses, masses scaled, frictions."""
    with panels(path, REGIONS, TITLE, *boxes(REGIONS, 1, 3, top=1.05)) as drawn:
        plain, scaled, ground = drawn
        for (colour, mark, _), robot, floor in zip(SERIES, masses, frictions, strict=True):
            name = f"m̄ = {robot.mass_bar:g}"
            outline(plain, robot, colour, mark, name)
            outline(scaled, robot, colour, mark, name, robot.mass_bar)
            outline(ground, floor, colour, mark, f"μ = {floor.mu:g}")
        limits = ground.get_xlim(), ground.get_ylim()
        for (colour, _, _), region in zip(SERIES, frictions, strict=True):
            high = limits[1][1]
            ground.plot([0.0, 2.0 * region.mu * high], [0.0, high], ":", color=colour, lw=1.4)
        ground.set(xlim=limits[0], ylim=limits[1])
        for axes, unit in zip(drawn, ("", "m̄ ", ""), strict=True):
            axes.set(xlabel=f"{unit}x / L", ylabel=f"{unit}y / L")
            legend_above(axes, 3, handlelength=1.2)


def patch(axes: Any, shape: Any, **style: Any) -> None:
    """A region of this style."""
    from matplotlib.patches import PathPatch

    axes.add_patch(PathPatch(compound(shape), **style))
    axes.autoscale_view()


def outline(axes: Any, region: Any, colour: str, mark: str, label: str, scale: float = 1.0) -> None:
    """One region, filled, with marks at the corners of the controls, and the forward model's."""
    import shapely

    ours, learned = (
        shapely.transform(one, lambda points: scale * points)
        for one in (region.outline, region.learned)
    )
    patch(axes, ours, facecolor=colour, alpha=0.12, lw=0.0)
    patch(axes, ours, fill=False, edgecolor=colour, lw=1.8)
    corners = scale * region.apexes[[0, 0, -1, -1], [0, -1, 0, -1]]
    axes.plot(*corners.T, mark, ms=7, color=colour, mec=palette.PAPER, zorder=5)
    axes.plot([], [], color=colour, lw=1.8, marker=mark, ms=7, mec=palette.PAPER, label=label)
    patch(axes, learned, fill=False, edgecolor=palette.INK, lw=0.9, ls=(0, (4, 2.5)))


def draw_settings(pairs: Sequence[tuple[Any, Any]], path: Path) -> None:
    """Regions at standard, with lines of constant mismatch and of constant pre-compression, each
    with that of the paper's settings."""
    places = boxes(SETTINGS, 1, len(pairs), top=0.95, across=0.5)
    title = "At standard (filled), and at the paper's settings"
    with panels(path, SETTINGS, title, *places) as drawn:
        for axes, (region, paper) in zip(drawn, pairs, strict=True):
            axes.set_title(f"m̄ = {region.mass_bar:g}, μ = {region.mu:g}", loc="left")
            patch(axes, region.outline, color=palette.SKY, alpha=0.25, lw=0)
            for k in np.arange(0, len(region.apexes), 2):
                axes.plot(*region.apexes[k].T, color=palette.BEAM, lw=0.6, alpha=0.8)
                axes.plot(*region.apexes[:, k].T, color=palette.PLUM, lw=0.6, alpha=0.8)
            patch(axes, paper.outline, fill=False, ec=palette.INK, lw=1.3)
            axes.set_xlabel("x / L")
        drawn[0].set_ylabel("y / L")
