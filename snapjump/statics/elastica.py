"""The exact clamped-clamped elastica, as a first guess for Newton's method."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.number.dispatch import compiled, routine
from snapjump.number.functions import sqrt
from snapjump.number.trigonometry import arctan, sin

Array = NDArray[np.float64]
HALVINGS = 60
LANDEN_STEPS = 6  # each squares the distance of the two means: five are exact up to m = 0.99
LARGEST_PARAMETER = 0.99


@routine
def landen(m: float, a: Any, c: Any) -> float:
    """Arithmetic-geometric means of the parameter m, a_n and c_n; returns the end shortening.

    It is 2 - 2 E(m)/K(m) = sum of 2^n c_n^2 (Abramowitz and Stegun 17.6).
    """
    a[0] = 1.0
    b = sqrt(1.0 - m)
    c[0] = sqrt(m)
    shortening = m
    for n in range(1, LANDEN_STEPS + 1):
        a[n] = 0.5 * (a[n - 1] + b)
        c[n] = 0.5 * (a[n - 1] - b)
        b = sqrt(a[n - 1] * b)
        shortening += 2.0**n * c[n] * c[n]
    return shortening


@compiled
def place_arch(epsilon: float, x: Any, y: Any) -> None:
    """Fill the nodes (elements + 1) of one arch of end shortening epsilon."""
    elements = x.shape[0] - 1
    a = np.empty(LANDEN_STEPS + 1)
    c = np.empty(LANDEN_STEPS + 1)
    low, high = 0.0, LARGEST_PARAMETER
    for _ in range(HALVINGS):
        m = 0.5 * (low + high)
        if landen(m, a, c) > epsilon:
            high = m
        else:
            low = m
    m = 0.5 * (low + high)
    landen(m, a, c)
    # sn(4 K s) by descending Landen transformations (Abramowitz and Stegun 16.4), each of all
    # elements, which the processor then takes several at a time.
    phase = np.empty(elements)
    for j in range(elements):
        phase[j] = 2.0 ** (LANDEN_STEPS + 1) * np.pi * ((j + 0.5) / elements)
    for n in range(LANDEN_STEPS, 0, -1):
        share = c[n] / a[n]
        for j in range(elements):
            t = share * sin(phase[j])
            phase[j] = 0.5 * (phase[j] + arctan(t / sqrt(1.0 - t * t)))
    x[0] = 0.0
    y[0] = 0.0
    for j in range(elements):
        half = sqrt(m) * sin(phase[j])  # sine of half the tangent's angle
        x[j + 1] = x[j] + (1.0 - 2.0 * half * half) / elements
        y[j + 1] = y[j] + 2.0 * half * sqrt(1.0 - half * half) / elements
    stretch = (1.0 - epsilon) / x[elements]
    for j in range(elements + 1):
        x[j] = x[j] * stretch - 0.5 * (1.0 - epsilon)


def buckled_arch(epsilon: float | Array, elements: int) -> tuple[Array, Array]:
    """Nodes (x, y), each (..., elements + 1), of arches buckled up between flat clamps, in L.

    Of end shortenings epsilon (...), with the tangent 2 asin(sqrt(m) sn(4 K s)); x runs from
    -(1 - epsilon)/2 to (1 - epsilon)/2 and y is measured from the clamps.
    """
    shortening = np.asarray(epsilon, dtype=float)
    x, y = np.empty((2, *shortening.shape, elements + 1))
    for k in np.ndindex(shortening.shape):
        place_arch(shortening[k], x[k], y[k])
    return x, y


def resampled(values: Array, skipped: float, elements: int) -> Array:
    """A nodal field (..., N) of the whole beam at ``elements`` + 1 nodes that begin ``skipped``
    further in (share of the length), for chains that start inside their clamps."""
    last = values.shape[-1] - 1
    places = last * np.linspace(skipped, 1.0 - skipped, elements + 1)
    before = np.minimum(places.astype(int), last - 1)
    share = places - before
    return (1.0 - share) * values[..., before] + share * values[..., before + 1]
