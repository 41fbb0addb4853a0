"""The achievable region with its lines of constant control, and the miss of every design."""

from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.targets.designed import Designed
from snapjump.targets.region import AchievableRegion

LINES = 5  # of either kind
LABELS = ("mismatch Δα (rad)", "pre-compression ε")
FIRST, SECOND = palette.BEAM, palette.PLUM


def draw_region(axes: Any, region: AchievableRegion) -> None:
    """The region, filled, and lines of constant mismatch and of constant pre-compression."""
    from matplotlib.patches import PathPatch

    patch = PathPatch(
        compound(region.outline()), facecolor=palette.SKY, alpha=0.22, lw=0.0, zorder=2,
        label="achievable",
    )  # fmt: skip
    axes.add_patch(patch)
    last = len(region.apexes) - 1
    for place in np.linspace(0, last, LINES).round().astype(int):
        axes.plot(*region.apexes[place].T, color=FIRST, lw=0.9, alpha=0.8, zorder=3)
        axes.plot(*region.apexes[:, place].T, color=SECOND, lw=0.9, alpha=0.8, zorder=3)
        tell(axes, region.apexes[place, -1], f"{region.controls[place, 0, 0]:.3g}", FIRST, (0, 4))
        tell(axes, region.apexes[0, place], f"{region.controls[0, place, 1]:.3g}", SECOND, (-4, 0))
    axes.plot([], [], color=FIRST, lw=1.2, label="constant Δα (rad)")
    axes.plot([], [], color=SECOND, lw=1.2, label="constant ε")


def tell(axes: Any, place: Any, text: str, colour: str, shift: tuple[int, int]) -> None:
    """A line's value at its end."""
    axes.annotate(
        text, place, xytext=shift, textcoords="offset points", color=colour, fontsize=8.5,
        ha="center" if shift[0] == 0 else "right", va="bottom" if shift[0] == 0 else "center",
        zorder=5, annotation_clip=True,
    )  # fmt: skip


def compound(outline: Any) -> Any:
    """A geometry, holes and all, as a path of matplotlib."""
    from matplotlib.path import Path
    from shapely.geometry.polygon import orient

    # Holes are what runs the other way round.
    parts = [
        orient(part) for part in getattr(outline, "geoms", [outline]) if part.geom_type == "Polygon"
    ]
    rings = [ring for part in parts for ring in (part.exterior, *part.interiors)]
    return Path.make_compound_path(*[Path(np.asarray(ring.coords), closed=True) for ring in rings])


def draw_map(
    figure: Any,
    place: tuple[float, float, float, float],
    designed: Designed,
    region: AchievableRegion,
) -> None:
    """Predicted distance from the target over the controls, with every solution."""
    from matplotlib.colors import PowerNorm
    from matplotlib.ticker import MultipleLocator

    axes = figure.add_axes(place)
    misses = np.hypot(*np.moveaxis(region.apexes - designed.problem.target, -1, 0))
    delta_alpha, epsilon = region.controls[:, 0, 0], region.controls[0, :, 1]
    shown = axes.pcolormesh(
        delta_alpha, epsilon, misses.T, cmap="viridis_r", norm=PowerNorm(0.5), shading="gouraud"
    )
    left, bottom, width, height = place
    bar = figure.colorbar(shown, cax=figure.add_axes((left + width + 0.008, bottom, 0.01, height)))
    bar.set_label("predicted distance from the target / L")
    others = np.array([s.controls for s in designed.answer.solutions[1:]]).reshape(-1, 2)
    if len(others):
        axes.plot(*others.T, "o", ms=8, mfc=palette.PAPER, mec=palette.INK, label="other solutions")
    if designed.robust is not None:
        axes.plot(
            *designed.robust.plain.controls, "D", ms=8, mfc=palette.PAPER, mec=palette.INK,
            label="plain design",
        )  # fmt: skip
    axes.plot(
        *designed.chosen.controls, "*", ms=15, color=palette.FORCE, mec=palette.PAPER,
        label="chosen design" if designed.robust is None else "robust design", clip_on=False,
        zorder=9,
    )  # fmt: skip
    axes.set(xlabel=LABELS[0], ylabel=LABELS[1])
    axes.xaxis.set_major_locator(MultipleLocator(0.05))
    axes.legend(
        loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2, borderaxespad=0.2, borderpad=0.0,
        handlelength=1.2, columnspacing=1.2,
    )  # fmt: skip
