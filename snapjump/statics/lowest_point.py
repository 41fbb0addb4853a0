"""The lowest point of a beam, between its nodes."""

import numpy as np
from numpy.typing import NDArray

DEGREE = 5
NEWTON_STEPS = 8


def lowest_height(heights: NDArray[np.float64]) -> float:
    """Height of the lowest point of the curve through nodes (N >= 6), in the unit of ``heights``.

    The curve is the quintic spline through all nodes, so that the height is a smooth function
    (four times differentiable) of theirs, whichever nodes the lowest point lies between.
    """
    from scipy.interpolate import make_interp_spline

    lowest = int(np.argmin(heights))
    if lowest in (0, len(heights) - 1):
        return float(heights[lowest])
    curve = make_interp_spline(np.arange(len(heights)), heights, k=DEGREE)
    slope, bend = curve.derivative(1), curve.derivative(2)
    place = float(lowest)
    for _ in range(NEWTON_STEPS):
        step = float(slope(place) / bend(place))
        place = min(max(place - step, lowest - 1.0), lowest + 1.0)
        if abs(step) < 1e-10:
            break
    return float(curve(place))
