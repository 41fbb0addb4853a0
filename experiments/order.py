"""Orders of convergence and Richardson's extrapolation, on ladders of any spacing."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

HIGHEST = 12.0
LOWEST = 0.05
# Two successive orders that differ by more are no sign of a limit that is being approached.
SPREAD = 0.35


@dataclass(frozen=True)
class Limit:
    """The limit of values as their refinement goes to zero.

    ``order``: observed on the last three values (NaN if they do not approach anything);
    ``asymptotic``: whether the last two such orders agree. If they do not, ``value`` is the finest
    one and ``uncertainty`` the range of the last three.
    """

    value: float
    uncertainty: float
    order: float
    asymptotic: bool


def fitted_order(sizes: Sequence[float], errors: Sequence[float]) -> float:
    """Slope of log error over log size, by least squares; NaN with fewer than two errors."""
    h, e = np.asarray(sizes, float), np.asarray(errors, float)
    good = np.isfinite(h) & np.isfinite(e) & (e > 0.0)
    if good.sum() < 2:
        return math.nan
    return float(np.polyfit(np.log(h[good]), np.log(e[good]), 1)[0])


def observed_order(sizes: Sequence[float], values: Sequence[float]) -> float:
    """The p for which three values are a + b h^p exactly; NaN if they are not monotone.
    Celik et al., J. Fluids Eng. 130 (2008) 078001, for any two ratios of sizes."""
    from scipy.optimize import brentq

    (h1, h2, h3), (f1, f2, f3) = sizes, values
    approaching = (f2 - f1) * (f3 - f2) > 0.0
    if not (approaching and h1 > h2 > h3 > 0.0):  # NaN neither approaches nor falls
        return math.nan
    wanted = math.log((f2 - f1) / (f3 - f2))

    def excess(p: float) -> float:
        ratio = (1.0 - (h2 / h1) ** p) / ((h2 / h1) ** p * (1.0 - (h3 / h2) ** p))
        return math.log(ratio) - wanted

    if excess(LOWEST) * excess(HIGHEST) >= 0.0:
        return math.nan
    return float(brentq(excess, LOWEST, HIGHEST))


def extrapolated(sizes: Sequence[float], values: Sequence[float], order: float) -> float:
    """The limit of a + b h^order through the last two of the values."""
    ratio = (sizes[-2] / sizes[-1]) ** order
    return values[-1] + (values[-1] - values[-2]) / (ratio - 1.0)


def richardson(sizes: Sequence[float], values: Sequence[float]) -> Limit:
    """The limit of values whose sizes fall, coarsest first; needs four for a verdict.
    The uncertainty is the change between the last two extrapolations, each with its own order."""
    last = [float(v) for v in values[-3:]]
    order = observed_order(sizes[-3:], last) if len(last) == 3 else math.nan
    before = observed_order(sizes[-4:-1], values[-4:-1]) if len(values) > 3 else math.nan
    agree = abs(order - before) <= SPREAD * max(order, before)
    if not agree:  # NaN never agrees
        return Limit(last[-1], max(last) - min(last), order, False)
    now = extrapolated(sizes, values, order)
    earlier = extrapolated(sizes[:-1], values[:-1], before)
    return Limit(now, abs(now - earlier), order, True)
