"""The exact clamped-clamped elastica, as a first guess for Newton's method."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
HALVINGS = 60


def modulus(epsilon: Array) -> Array:
    """The parameter m of the elastica whose end shortening is 2 - 2 E(m)/K(m) = epsilon."""
    from scipy.special import ellipe, ellipk

    low, high = np.full_like(epsilon, 1e-12), np.full_like(epsilon, 0.99)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        beyond = 2.0 - 2.0 * ellipe(middle) / ellipk(middle) > epsilon
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return 0.5 * (low + high)


def buckled_arch(epsilon: float | Array, elements: int) -> tuple[Array, Array]:
    """Nodes (x, y), each (..., elements + 1), of arches buckled up between flat clamps, in L.

    Of end shortenings epsilon (...), with the tangent 2 asin(sqrt(m) sn(4 K s)); x runs from
    -(1 - epsilon)/2 to (1 - epsilon)/2 and y is measured from the clamps.
    """
    from scipy.special import ellipj, ellipk

    shortening = np.asarray(epsilon, dtype=float)[..., None]
    m = modulus(shortening)
    s = (np.arange(elements) + 0.5) / elements
    sine = ellipj(4.0 * ellipk(m) * s, m)[0]
    tangent = 2.0 * np.arcsin(np.sqrt(m) * sine)
    origin = np.zeros_like(shortening)
    x = np.concatenate([origin, np.cumsum(np.cos(tangent), axis=-1)], axis=-1) / elements
    y = np.concatenate([origin, np.cumsum(np.sin(tangent), axis=-1)], axis=-1) / elements
    span = 1.0 - shortening
    return x * (span / x[..., -1:]) - 0.5 * span, y


def resampled(values: Array, skipped: float, elements: int) -> Array:
    """A nodal field (..., N) of the whole beam at ``elements`` + 1 nodes that begin ``skipped``
    further in (share of the length), for chains that start inside their clamps."""
    last = values.shape[-1] - 1
    places = last * np.linspace(skipped, 1.0 - skipped, elements + 1)
    before = np.minimum(places.astype(int), last - 1)
    share = places - before
    return (1.0 - share) * values[..., before] + share * values[..., before + 1]
