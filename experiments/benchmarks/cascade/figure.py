"""cascade.png: heights of jumps by pre-compression, with what is unknown, and the source's."""

from collections.abc import Sequence
from pathlib import Path

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ...styles import boxes

SIZE = (8.5, 4.8)


def draw_heights(
    rows: Sequence[Row], band: Sequence[Row], ends: tuple[float, float], theirs: float, path: Path
) -> None:
    """``ends``: of the band (m)."""
    title = "How high a robot of 1.6 g and 20 mm jumps"
    with panels(path, SIZE, title, *boxes(SIZE, 1, 1, left=0.8, right=2.6)) as (axes,):
        axes.axhspan(*ends, color=palette.GROUND, lw=0, zorder=0)
        axes.plot(
            column(band, "design.epsilon"), column(band, "height_m"), ".", ms=4,
            color=palette.QUIET, label="what is unknown, varied\n(shaded: 5 to 95 %)",
        )  # fmt: skip
        epsilon = column(rows, "design.epsilon")
        axes.plot(epsilon, column(rows, "height_m"), color=palette.BEAM, lw=2.2, label="no drag")
        axes.plot(
            epsilon, column(rows, "with_drag_m"), color=palette.BEAM, lw=1.6, ls="--",
            label="drag of its top plate",
        )  # fmt: skip
        axes.axhline(theirs, color=palette.FORCE, lw=1.6, label="the source's")
        axes.set(xlabel="pre-compression ε", ylabel="height (m)", ylim=(0.0, None))
        axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))
