"""The exact clamped-clamped elastica, as a first guess for Newton's method."""

import numpy as np
from numpy.typing import NDArray


def buckled_arch(epsilon: float, elements: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Nodes (x, y), each (elements + 1), of the arch buckled up between flat clamps, in L.

    End shortening epsilon = 2 - 2 E(m)/K(m), tangent 2 asin(sqrt(m) sn(4 K s)); x runs from
    -(1 - epsilon)/2 to (1 - epsilon)/2 and y is measured from the clamps.
    """
    from scipy.optimize import brentq
    from scipy.special import ellipe, ellipj, ellipk

    m = brentq(lambda m: 2.0 - 2.0 * ellipe(m) / ellipk(m) - epsilon, 1e-12, 0.99)
    s = (np.arange(elements) + 0.5) / elements
    sine = ellipj(4.0 * ellipk(m) * s, m)[0]
    tangent = 2.0 * np.arcsin(np.sqrt(m) * sine)
    x = np.concatenate([[0.0], np.cumsum(np.cos(tangent))]) / elements
    y = np.concatenate([[0.0], np.cumsum(np.sin(tangent))]) / elements
    span = 1.0 - epsilon
    return x * (span / x[-1]) - 0.5 * span, y


def resampled(values: NDArray[np.float64], skipped: float, elements: int) -> NDArray[np.float64]:
    """A nodal field of the whole beam at ``elements`` + 1 nodes that begin ``skipped`` further in
    (share of the length), for chains that start inside their clamps."""
    old = np.linspace(0.0, 1.0, len(values))
    return np.interp(np.linspace(skipped, 1.0 - skipped, elements + 1), old, values)
