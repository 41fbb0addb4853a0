"""Values between the steps of a march, of figures that are known at every step: at a moment, at a
fall through zero, at a peak."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array


def falls(values: Array) -> NDArray[np.int64]:
    """The steps k with a value above zero whose next one (k + 1) is not."""
    return np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))


def cubic(times: Array, values: Array, k: int) -> Callable[[float], float]:
    """Between steps k and k + 1 the cubic through the four nearest, of the time since step k; at
    either end the parabola through three. Newton's form, by plain numbers: its bits depend neither
    on the processor nor, as those of scipy's interpolators may, on chance."""
    near = slice(max(0, k - 1), k + 3)
    nodes, differences = (times[near] - times[k]).tolist(), values[near].tolist()
    for order in range(1, len(nodes)):
        for i in range(len(nodes) - 1, order - 1, -1):
            rise = differences[i] - differences[i - 1]
            differences[i] = rise / (nodes[i] - nodes[i - order])

    def value(moment: float) -> float:
        found: float = 0.0
        for node, difference in zip(nodes[::-1], differences[::-1], strict=True):
            found = difference + (moment - node) * found
        return found

    return value


def crossing(times: Array, values: Array, which: int = 0) -> float:
    """When values fall through zero, first or, with ``which`` = -1, last; NaN if they do not."""
    from scipy.optimize import brentq

    fallen = falls(values)
    if len(fallen) == 0:
        return float("nan")
    k = int(fallen[which])
    between, step = cubic(times, values, k), times[k + 1] - times[k]
    share = brentq(lambda part: between(part * step), 0.0, 1.0, xtol=1e-12)
    return float(times[k] + share * step)


def at(times: Array, values: Array, moment: float) -> float:
    """The value at a moment of the march."""
    k = min(max(int(np.searchsorted(times, moment)) - 1, 0), len(times) - 1)
    return float(cubic(times, values, k)(moment - times[k]))


def vertices(times: Array, values: Array, tops: NDArray[np.int64]) -> tuple[Array, Array]:
    """Moments and values (K) of the peaks at steps (K) that are lower on neither side: of the
    parabolas through each and its neighbours."""
    left, right = times[tops - 1] - times[tops], times[tops + 1] - times[tops]
    down = (values[tops - 1] - values[tops]) / left
    up = (values[tops + 1] - values[tops]) / right
    bend = (up - down) / (right - left)
    slope = down - bend * left
    round_top = bend < 0.0  # else three equal values
    ahead = np.where(round_top, -0.5 * slope / np.where(round_top, bend, 1.0), 0.0)
    return times[tops] + ahead, values[tops] + 0.5 * slope * ahead


def peak(times: Array, values: Array) -> float:
    """The largest value, at a step or between them; NaN without any."""
    if len(values) == 0:
        return float("nan")
    inner = values[1:-1]
    tops = 1 + np.flatnonzero((inner >= values[:-2]) & (inner >= values[2:]))
    return float(np.append(vertices(times, values, tops)[1], values).max())
