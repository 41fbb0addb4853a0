"""The achievable region: all apexes that one environment allows, by the forward model."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from snapjump.arrays import Array
from snapjump.inverse.base import ForwardModel, Problem
from snapjump.inverse.gauss_newton import grid_triangles

# Per control: enough that the forward model's own error is what decides at the boundary.
POINTS = 21


@dataclass(frozen=True)
class AchievableRegion:
    """The image of the rectangle of controls: that of a grid of them, mapped linearly in between.

    The map may fold, so that some apexes have several designs: the region is the union of the
    images of the grid's triangles (T). ``controls``, ``apexes`` (n, n, 2): the grid, delta_alpha
    along the first axis; ``corners`` (T, 3, 2): controls of the triangles; ``triangles``: a tree of
    their images. Source: the paper, its section on the achievable region.
    """

    controls: Array
    apexes: Array
    corners: Array
    triangles: shapely.STRtree

    @classmethod
    def of(
        cls, problem: Problem, forward: ForwardModel, points: int = POINTS
    ) -> "AchievableRegion":
        """The region of a problem's environment, from points^2 predictions."""
        controls = problem.grid(points)
        apexes = forward.predict(problem.designs(controls.reshape(-1, 2))).reshape(controls.shape)
        images = shapely.polygons(grid_triangles(apexes))
        return cls(controls, apexes, grid_triangles(controls), shapely.STRtree(images))

    def contains(self, targets: Array) -> NDArray[np.bool_]:
        """Which of the targets (N, 2) it holds, by ray casting; its boundary belongs to it."""
        held = np.zeros(len(targets), dtype=bool)
        held[self.triangles.query(shapely.points(targets), predicate="intersects")[0]] = True
        return held

    def nearest(self, target: Array) -> tuple[Array, Array]:
        """The reachable apex (2,) nearest to a target (2,), and its controls (2,)."""
        place = shapely.Point(target)
        k = int(self.triangles.nearest(place))
        triangle = self.triangles.geometries[k]
        apex = shapely.get_coordinates(shapely.shortest_line(triangle, place))[0]
        image = shapely.get_coordinates(triangle)[:3]
        # A triangle may be mapped to a line: the least of all weights that will do.
        weights, *_ = np.linalg.lstsq(
            np.vstack([image.T, np.ones(3)]), np.array([*apex, 1.0]), rcond=None
        )
        weights = np.clip(weights, 0.0, None)
        return weights @ self.corners[k] / weights.sum(), apex

    def outline(self) -> Any:
        """All of it as one geometry, for pictures."""
        return shapely.union_all(shapely.make_valid(self.triangles.geometries))
