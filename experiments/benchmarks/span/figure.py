"""span.png: largest tilt against mismatch at every rate."""

from collections.abc import Sequence
from pathlib import Path

from snapjump.run.studies.base import Row, column
from snapjump.show.plots.saving import panels

from ...styles import SERIES, boxes

SIZE = (8.5, 4.8)


def draw_tilts(rows: Sequence[Row], path: Path) -> None:
    """Both logarithmic, a line for each rate."""
    title = "The faster the span opens, the less a mismatch tilts the snap"
    with panels(path, SIZE, title, *boxes(SIZE, 1, 1, left=0.95, right=2.2)) as (axes,):
        for rate, (colour, mark, line) in zip(
            sorted({row["rate_m_s"] for row in rows}), SERIES, strict=False
        ):
            own = [row for row in rows if row["rate_m_s"] == rate]
            lags, tilts = (column(own, key) for key in ("delta_alpha_rad", "theta_max_rad"))
            axes.plot(lags, tilts, color=colour, marker=mark, ls=line, ms=6, label=f"{rate:g} m/s")
        axes.set(xscale="log", yscale="log", xlabel="mismatch Δα (rad)")
        axes.set_ylabel("largest tilt of the midpoint (rad)")
        axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))
