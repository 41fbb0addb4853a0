"""regions.png and regions_settings.png: outlines of achievable regions."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper.regions.judge import Array, Region
from snapjump.show.plots import palette
from snapjump.show.plots.achievable import compound
from snapjump.show.plots.saving import picture

STYLES = (
    (palette.BEAM, "o"),
    (palette.CLAMP, "s"),
    (palette.CENTRE, "^"),
    (palette.FORCE, "D"),
    (palette.PLUM, "v"),
)
TITLE = "Achievable regions of simulated robots (filled) and by the forward model (dashed)"


def draw_regions(masses: Sequence[Region], frictions: Sequence[Region], path: Path) -> None:
    """Masses, masses scaled, frictions."""
    with picture(path, (15.0, 6.4), TITLE) as figure:
        places = [(0.045 + 0.325 * k, 0.1, 0.285, 0.74) for k in range(3)]
        plain, scaled, ground = (figure.add_axes(place) for place in places)
        for style, region in zip(STYLES, masses, strict=True):
            outline(plain, region, style, f"m̄ = {region.mass_bar:g}")
            outline(scaled, region, style, f"m̄ = {region.mass_bar:g}", region.mass_bar)
        for style, region in zip(STYLES, frictions, strict=True):
            outline(ground, region, style, f"μ = {region.mu:g}")
        limits = ground.get_xlim(), ground.get_ylim()
        for (colour, _), region in zip(STYLES, frictions, strict=True):
            high = limits[1][1]
            ground.plot([0.0, 2.0 * region.mu * high], [0.0, high], ":", color=colour, lw=1.4)
        ground.set(xlim=limits[0], ylim=limits[1])
        for axes, unit in ((plain, ""), (scaled, "m̄ "), (ground, "")):
            axes.set(xlabel=f"{unit}x / L", ylabel=f"{unit}y / L")
            axes.grid(True)
            axes.legend(
                loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, borderaxespad=0.2,
                borderpad=0.0, handlelength=1.2, columnspacing=1.2,
            )  # fmt: skip


def outline(
    axes: Any, region: Region, style: tuple[str, str], label: str, scale: float = 1.0
) -> None:
    """One region, filled, with marks at the corners of the controls, and the forward model's."""
    import shapely
    from matplotlib.patches import PathPatch

    ours, learned = (
        compound(shapely.transform(one, lambda points: scale * points))
        for one in (region.outline, region.learned)
    )
    colour, marker = style
    axes.add_patch(PathPatch(ours, facecolor=colour, alpha=0.12, lw=0.0))
    axes.add_patch(PathPatch(ours, fill=False, edgecolor=colour, lw=1.8))
    corners = scale * region.apexes[[0, 0, -1, -1], [0, -1, 0, -1]]
    axes.plot(*corners.T, marker, ms=7, color=colour, mec=palette.PAPER, zorder=5)
    axes.plot([], [], color=colour, lw=1.8, marker=marker, ms=7, mec=palette.PAPER, label=label)
    axes.add_patch(PathPatch(learned, fill=False, edgecolor=palette.INK, lw=0.9, ls=(0, (4, 2.5))))
    axes.autoscale_view()


def draw_settings(pairs: Sequence[tuple[Region, Region]], path: Path) -> None:
    """Regions at standard, each with that of the paper's settings."""
    from matplotlib.patches import PathPatch

    with picture(path, (15.0, 5.2), "At standard (filled), and at the paper's settings") as figure:
        for k, (region, paper) in enumerate(pairs):
            axes = figure.add_axes((0.04 + 0.194 * k, 0.12, 0.155, 0.72))
            axes.set_title(f"m̄ = {region.mass_bar:g}, μ = {region.mu:g}", loc="left")
            axes.add_patch(PathPatch(compound(region.outline), color=palette.SKY, alpha=0.25, lw=0))
            grid(axes, region.apexes)
            axes.add_patch(PathPatch(compound(paper.outline), fill=False, ec=palette.INK, lw=1.3))
            axes.autoscale_view()
            axes.set_xlabel("x / L")
            axes.grid(True)
            if k == 0:
                axes.set_ylabel("y / L")


def grid(axes: Any, apexes: Array) -> None:
    """Lines of constant mismatch and of constant pre-compression."""
    for k in np.arange(0, len(apexes), 2):
        axes.plot(*apexes[k].T, color=palette.BEAM, lw=0.6, alpha=0.8)
        axes.plot(*apexes[:, k].T, color=palette.PLUM, lw=0.6, alpha=0.8)
