"""Measures of error: relative to the converged limit, and roughness.

Errors of x are relative to max(|x|, 0.1 y), since x goes through zero. Roughness is the standard
deviation (in L) of the result less the converged one, about a line, when delta_alpha is swept in
steps of 0.001 about the baseline: what a surrogate or an optimiser sees as noise.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.run.studies.base import Row, column


def scale_of_x(x: Any, y: Any) -> Any:
    """The scale that errors of x are relative to."""
    return np.maximum(np.abs(x), 0.1 * y)


def relative_errors(x: Array, y: Array, x_limit: Array, y_limit: Array) -> tuple[Array, Array]:
    """Errors of x and y in percent, NaN where either is missing."""
    return (
        100.0 * np.abs(x - x_limit) / scale_of_x(x_limit, y_limit),
        100.0 * np.abs(y - y_limit) / y_limit,
    )


def error_figures(x: Array, y: Array) -> dict[str, float]:
    """Medians and 95th percentiles of errors of x and y (%), in which failures are infinite."""
    return {
        f"{name}_{words}_percent": percentile(errors, share)
        for name, errors in (("x", x), ("y", y))
        for words, share in (("median", 50.0), ("p95", 95.0))
    }


def percentile(errors: Array, share: float) -> float:
    """A percentile in which a failure counts as an infinite error."""
    if len(errors) == 0:
        return float("nan")
    ranked = np.sort(np.where(np.isfinite(errors), errors, np.inf))
    place = share / 100.0 * (len(ranked) - 1)
    low, high = ranked[int(np.floor(place))], ranked[int(np.ceil(place))]
    return float(low if low == high else low + (high - low) * (place - np.floor(place)))


def roughness(values: Array) -> float:
    """Standard deviation about a line; NaN if any value is missing."""
    place = np.arange(len(values))
    if len(values) < 3 or not np.isfinite(values).all():
        return float("nan")
    return float(np.std(values - np.polyval(np.polyfit(place, values, 1), place)))


@dataclass(frozen=True)
class Shift:
    """How far apexes move when something is changed: medians and 95th percentiles (%), x relative
    to max(|x|, 0.1 y); ``y_signed``: the median with its sign. What failed is infinitely far."""

    x_median: float
    x_p95: float
    y_median: float
    y_p95: float
    y_signed: float

    @property
    def medians(self) -> float:
        """The larger median."""
        return max(self.x_median, self.y_median)

    @property
    def p95(self) -> float:
        """The larger 95th percentile."""
        return max(self.x_p95, self.y_p95)


def shift(rows: Sequence[Row], base: Sequence[Row]) -> Shift:
    """The shift of the jumps of some rows from those of others."""
    x, y, x0, y0 = (column(r, key) for r in (rows, base) for key in ("x_bar", "y_bar"))
    (x_median, x_p95), (y_median, y_p95) = (
        [percentile(errors, share) for share in (50.0, 95.0)]
        for errors in relative_errors(x, y, x0, y0)
    )
    signed = float(np.nanmedian(100.0 * (y / y0 - 1.0)))
    return Shift(x_median, x_p95, y_median, y_p95, signed)
