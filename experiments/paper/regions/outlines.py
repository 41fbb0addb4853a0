"""Regions as geometries: the union of the images of a grid's triangles."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from snapjump.inverse.gauss_newton import grid_triangles
from snapjump.studies.base import Done

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Region:
    """``apexes``, ``predicted`` (n, n, 2): of the grid of controls, in L, delta_alpha along the
    first axis, NaN where the robot does not jump; ``outline``, ``learned``: their regions."""

    mass_bar: float
    mu: float
    apexes: Array
    predicted: Array
    outline: Any
    learned: Any

    def width_bar(self, height_bar: float) -> float:
        """How much of a horizontal line at a height (L) is in the region, in L."""
        low, _, high, _ = self.outline.bounds
        line = shapely.LineString([(low, height_bar), (high, height_bar)])
        return float(self.outline.intersection(line).length)

    @property
    def coarser(self) -> Any:
        """The region by every second design alone."""
        return outline_of(self.apexes[::2, ::2])

    @property
    def cone_share(self) -> float:
        """The largest share of 2 mu y that an x is, which is what the friction cone allows."""
        return float(np.nanmax(self.apexes[..., 0] / (2.0 * self.mu * self.apexes[..., 1])))


def outline_of(apexes: Array) -> Any:
    """The region of a grid (n, n, 2) of apexes; triangles with a NaN are left out.

    Holes are filled: where the map folds there are slivers, narrower than the grid can tell.
    """
    triangles = grid_triangles(apexes)
    known = triangles[np.isfinite(triangles).all(axis=(1, 2))]
    whole = shapely.union_all(shapely.make_valid(shapely.polygons(known)))
    parts = [part for part in shapely.get_parts(whole) if part.geom_type == "Polygon"]
    return shapely.union_all([shapely.Polygon(part.exterior) for part in parts])


def region_of(done: Done) -> Region:
    """The region of a cell."""
    inputs = done.cell.inputs
    apexes, predicted = (
        np.stack([done.column(f"{kind}{axis}_bar") for axis in "xy"], axis=-1).reshape(
            inputs["points"], inputs["points"], 2
        )
        for kind in ("", "predicted_")
    )
    outlines = outline_of(apexes), outline_of(predicted)
    return Region(inputs["mass_bar"], inputs["mu"], apexes, predicted, *outlines)
