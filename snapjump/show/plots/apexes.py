"""apexes.png: where the jumps of a batch lead, coloured by the input that varies most."""

import pathlib

import numpy as np

from snapjump.batch import Batch
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels


def draw_apexes(batch: Batch, title: str, path: pathlib.Path) -> None:
    """Apexes in the plane of the jump; a jump without one has no point."""
    x, y = batch.apexes.T
    shown = np.isfinite(x)
    with panels(path, (8.0, 6.0), title, (0.1, 0.11, 0.86, 0.78)) as (axes,):
        varying = [name for name, values in batch.designs.items() if np.ptp(values) > 0.0]
        if varying:
            values = batch.designs[varying[0]][shown]
            points = axes.scatter(x[shown], y[shown], c=values, s=14, cmap="viridis", zorder=3)
            axes.figure.colorbar(points, ax=axes, label=varying[0])
        else:
            axes.plot(x[shown], y[shown], "o", ms=4, color=palette.BEAM, zorder=3)
        axes.set(xlabel="apex distance $x / L$", ylabel="apex height $y / L$")
