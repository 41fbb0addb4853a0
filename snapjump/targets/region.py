"""The achievable region: all apexes that one environment allows, by the forward model."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from snapjump.arrays import Array
from snapjump.inverse.base import ForwardModel, Problem
from snapjump.inverse.gauss_newton import grid_triangles

# Per control: enough that its boundary is as good as the forward model.
POINTS = 21


@dataclass(frozen=True)
class AchievableRegion:
    """The image of the rectangle of controls: that of a grid of them, mapped linearly in between.

    The map may fold, so that some apexes have several designs: the region is the union of the
    images of the grid's triangles (T). ``controls``, ``apexes`` (n, n, 2): the grid, delta_alpha
    along the first axis; ``triangles``: a tree of the images. Source: the paper, its section on the
    achievable region.
    """

    controls: Array
    apexes: Array
    triangles: shapely.STRtree

    @classmethod
    def of(
        cls, problem: Problem, forward: ForwardModel, points: int = POINTS
    ) -> "AchievableRegion":
        """The region of a problem's environment, from points^2 predictions."""
        controls = problem.grid(points)
        apexes = forward.predict(problem.designs(controls.reshape(-1, 2))).reshape(controls.shape)
        images = shapely.polygons(grid_triangles(apexes))
        return cls(controls, apexes, shapely.STRtree(images))

    def contains(self, targets: Array) -> NDArray[np.bool_]:
        """Which of the targets (N, 2) it holds, by ray casting; its boundary belongs to it."""
        held = np.zeros(len(targets), dtype=bool)
        held[self.triangles.query(shapely.points(targets), predicate="intersects")[0]] = True
        return held

    def outline(self) -> Any:
        """All of it as one geometry, for pictures."""
        return shapely.union_all(shapely.make_valid(self.triangles.geometries))


def filled_outline(apexes: Array) -> Any:
    """The region of a grid (n, n, 2) of apexes; triangles with a NaN are left out.

    Holes are filled: where the map folds there are slivers, narrower than the grid can tell.
    """
    triangles = grid_triangles(apexes)
    known = triangles[np.isfinite(triangles).all(axis=(1, 2))]
    whole = shapely.union_all(shapely.make_valid(shapely.polygons(known)))
    parts = [part for part in shapely.get_parts(whole) if part.geom_type == "Polygon"]
    return shapely.union_all([shapely.Polygon(part.exterior) for part in parts])


@dataclass(frozen=True)
class SimulatedRegion:
    """The region of a robot and a ground by simulation, with that by a forward model.

    ``apexes``, ``predicted`` (n, n, 2): of a grid of controls, in L, NaN where the robot does not
    jump; ``outline``, ``learned``: their regions.
    """

    mass_bar: float
    mu: float
    apexes: Array
    predicted: Array

    @cached_property
    def outline(self) -> Any:
        return filled_outline(self.apexes)

    @cached_property
    def learned(self) -> Any:
        return filled_outline(self.predicted)

    @property
    def least_y(self) -> float:
        return float(self.outline.bounds[1])

    @property
    def largest_y(self) -> float:
        return float(self.outline.bounds[3])

    @property
    def largest_x(self) -> float:
        return float(self.outline.bounds[2])

    @property
    def extent(self) -> tuple[float, float]:
        """Width and height in L."""
        left, low, right, high = self.outline.bounds
        return right - left, high - low

    @property
    def cone_share(self) -> float:
        """The largest share of 2 mu y that an x is, which is what the friction cone allows."""
        return float(np.nanmax(self.apexes[..., 0] / (2.0 * self.mu * self.apexes[..., 1])))

    def width_bar(self, height_bar: float) -> float:
        """How much of a horizontal line at a height (L) is in the region, in L."""
        low, _, high, _ = self.outline.bounds
        line = shapely.LineString([(low, height_bar), (high, height_bar)])
        return float(self.outline.intersection(line).length)

    def held(self, outer: "SimulatedRegion") -> float:
        """The share of the area that another one holds."""
        return float(self.outline.intersection(outer.outline).area / self.outline.area)
