"""symmetries.png: critical angles of shallow arches over sqrt(epsilon), and their errors."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots.saving import panels

from ...styles import SERIES, boxes

SIZE = (11.5, 4.6)
LABELS = {"one end": "one clamp turns", "alike": "both turn: first instability",
          "fold": "both turn: symmetric fold"}  # fmt: skip


def draw_angles(
    rows: Sequence[Row],
    meshes: Sequence[Row],
    theirs: Mapping[str, float],
    limits: Mapping[str, float],
    path: Path,
) -> None:
    """``rows``: of the finest mesh, by epsilon; ``meshes``: values at zero by number of elements;
    ``limits``: what they tend to."""
    title = "Critical angles of shallow arches"
    with panels(path, SIZE, title, *boxes(SIZE, 1, 2, left=0.9, across=1.0)) as (left, right):
        for (name, label), (colour, mark, line) in zip(LABELS.items(), SERIES, strict=False):
            style: Any = {"color": colour, "marker": mark, "ms": 6, "lw": 1.8}
            left.plot(column(rows, "epsilon"), column(rows, name), ls=line, label=label, **style)
            left.axhline(theirs[name], color=colour, lw=1.0, ls="--")
            off = 100.0 * np.abs(column(meshes, name) / limits[name] - 1.0)
            right.plot(column(meshes, "elements"), off, ls=line, **style)
        left.set(xlabel="pre-compression ε", ylabel="α / √ε (rad)", xlim=(0.0, None))
        left.set_ylim(1.75, 2.12)
        left.legend(loc="center right")
        right.set(xscale="log", yscale="log", xlabel="elements", ylabel="from the limit (%)")
        counts = column(meshes, "elements")
        right.set_xticks(counts, [f"{count:g}" for count in counts])
        right.set_xticks([], minor=True)
