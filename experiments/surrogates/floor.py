"""The floor: what the map does within a cell of the paper's grid that a cubic does not follow.

Random cells of the 15^4 grid are filled with as many jumps as a cubic polynomial needs several
times over. What that leaves unexplained, each jump left out in turn, is structure of the map (and
roughness of the tier) below the distance of the grid's points.
"""

from itertools import combinations_with_replacement

import numpy as np
from scipy.stats.qmc import Sobol

from snapjump.arrays import Array
from snapjump.batch import simulate_designs
from snapjump.composition import Simulation
from snapjump.plan.base import Range
from snapjump.run.studies.base import Row
from snapjump.statics.threshold_curve import ThresholdCurve

from ..designs import COLUMNS

INTERVALS = 14  # of the paper's grid along each input
JUMPS, FEWEST = 128, 60  # in a cell; a cubic of four variables has 35 coefficients
DEGREE = 3


def floor_rows(base: Simulation, ranges: tuple[Range, ...], cells: int, seed: int) -> list[Row]:
    """For each of so many random cells: its lowest corner, and the mean absolute error of the cubic
    in x and y (L). Jumps that fail are left out."""
    low, high = np.array(ranges).T
    size = (high - low) / INTERVALS
    rng = np.random.default_rng(seed)
    corners = low + size * rng.integers(0, INTERVALS, (cells, len(low)))
    unit = np.array([Sobol(len(low), rng=rng).random(JUMPS) for _ in range(cells)])
    designs = (corners[:, None] + size * unit).reshape(-1, len(low))
    curve = ThresholdCurve.over(base.robot, base.discretization, np.array(ranges[1]))
    batch = simulate_designs(base, designs, curve=curve, threads=1)
    apexes = np.column_stack([batch.x_bar, batch.y_bar]).reshape(cells, JUMPS, 2)
    rows = []
    for corner, points, found in zip(corners, unit, apexes, strict=True):
        known = np.isfinite(found).all(axis=1)
        errors = np.full(2, np.nan)
        if known.sum() >= FEWEST:
            errors = np.abs(left_out(2.0 * points[known] - 1.0, found[known])).mean(axis=0)
        place = {f"{name}_low": float(value) for name, value in zip(COLUMNS, corner, strict=True)}
        x, y = (float(error) for error in errors)
        rows.append({**place, "jumps": int(known.sum()), "x_bar": x, "y_bar": y})
    return rows


def left_out(points: Array, values: Array) -> Array:
    """Errors (N, 2) of the cubic at points (N, 4) in [-1, 1]^4, each fitted without that point."""
    terms = [
        np.prod(points[:, list(chosen)], axis=1)
        for degree in range(DEGREE + 1)
        for chosen in combinations_with_replacement(range(points.shape[1]), degree)
    ]
    matrix = np.column_stack(terms)
    hat = matrix @ np.linalg.pinv(matrix)
    found: Array = (values - hat @ values) / (1.0 - np.diag(hat))[:, None]
    return found
