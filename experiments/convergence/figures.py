"""ladders.png: a panel for each thing that is refined, a line for each observable."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.saving import axes_at, picture

from ..styles import label_decades
from .ladders import Ladder
from .verdict import Verdict

COLUMNS = 3
PANEL = (4.3, 4.2)  # inches
TOP = 0.6
HEADLINE = "Error against refinement; fitted order in brackets; dashed: not in the asymptotic range"
LOOKS = {
    "snap_time_s": ("snap time", palette.BEAM, "o"),
    "peak_force_N": ("peak force", palette.FORCE, "s"),
    "liftoff_speed_m_s": ("lift-off speed", palette.CENTRE, "^"),
    "x_bar": ("apex x", palette.PLUM, "D"),
    "y_bar": ("apex y", palette.CLAMP, "v"),
}


def draw_ladders(ladders: Sequence[Ladder], verdicts: Sequence[Verdict], path: Path) -> None:
    """Log-log errors in percent; orders are those of the fit, dashed where not asymptotic."""
    rows = -(-len(ladders) // COLUMNS)
    wide, high = PANEL
    with picture(path, (wide * COLUMNS, high * rows + TOP), HEADLINE) as figure:
        for k, ladder in enumerate(ladders):
            row, column = divmod(k, COLUMNS)
            bottom = (rows - 1 - row) * high + 0.65
            axes = axes_at(figure, column * wide + 0.75, bottom, wide - 0.9, high - 1.05)
            for verdict in verdicts:
                if verdict.ladder is ladder:
                    _draw(axes, verdict)
            axes.set(xscale="log", yscale="log", xlabel=ladder.label)
            axes.grid(True)
            axes.set_title(ladder.name, loc="left", fontweight="bold")
            label_decades(axes)
            if column == 0:
                axes.set_ylabel("error (%)")
            low, top = axes.get_ylim()
            axes.set_ylim(low, top * (top / low) ** 0.45)  # room for the legend
            axes.legend(loc="upper left", fontsize=8.5, ncols=1, handlelength=2.2)


def _draw(axes: Any, verdict: Verdict) -> None:
    name, colour, marker = LOOKS[verdict.observable]
    order = "no order" if np.isnan(verdict.fitted) else f"{verdict.fitted:.1f}"
    good = np.isfinite(verdict.errors) & (verdict.errors > 0.0)
    style = "-" if verdict.limit.asymptotic else "--"
    axes.plot(verdict.sizes[good], verdict.errors[good], marker=marker, ms=5, color=colour, lw=1.6,
              ls=style, label=f"{name} ({order})")  # fmt: skip
