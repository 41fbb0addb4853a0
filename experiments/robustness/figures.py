"""designs.png: where random designs jump, do not, or fail, and how many iterations they take."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

from ..designs import LABELS
from ..styles import label_decades

PLANES = (("delta_alpha_rad", "epsilon"), ("mass_bar", "mu"))
COLOURS = {"ok": palette.SKY, "no_jump": palette.CLAMP}
FAILED = (palette.FORCE, palette.PLUM, palette.CENTRE, palette.INK)


def draw_designs(rows: Sequence[Row], path: Path) -> None:
    """Two planes of the four parameters, and the distribution of Newton iterations."""
    names = [*COLOURS, *sorted({row["status"] for row in rows} - set(COLOURS))]
    others = dict(zip([n for n in names if n not in COLOURS], FAILED, strict=False))
    with picture(path, (15.0, 5.0), f"{len(rows)} random designs") as figure:
        for k, plane in enumerate(PLANES):
            axes = figure.add_axes((0.055 + 0.325 * k, 0.12, 0.27, 0.74))
            for name in names:
                some = [row for row in rows if row["status"] == name]
                usual = name in COLOURS
                axes.plot([row[plane[0]] for row in some], [row[plane[1]] for row in some],
                          "." if usual else "x", ms=2.2 if name == "ok" else 5,
                          color=COLOURS.get(name) or others.get(name, palette.INK),
                          alpha=0.6 if usual else 1.0, mew=0 if usual else 1.4,
                          label=f"{len(some)} {name}")  # fmt: skip
            axes.set(xlabel=LABELS[plane[0]], ylabel=LABELS[plane[1]])
            if k == 0:
                axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, markerscale=2.0)
        axes = figure.add_axes((0.73, 0.12, 0.25, 0.74))
        counts = np.array([n for row in rows if (n := row.get("newton_iterations", 0.0)) > 0.0])
        edges = np.geomspace(counts.min(), counts.max() * 1.01, 60)
        axes.hist(counts, edges, color=palette.BEAM, log=True)
        axes.set(xscale="log", xlabel="Newton iterations of a jump", ylabel="designs")
        label_decades(axes)
