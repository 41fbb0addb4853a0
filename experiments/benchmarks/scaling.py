"""Scaling laws: exponents and prefactors of times and delays close to a fold."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from snapjump.arrays import Array
from snapjump.run.studies.base import Row, column

from ..trends import power

FITTED = 3  # points: the last decade of places, half a decade apart


@dataclass(frozen=True)
class Scaling:
    """Values at places that come ever closer to a limit; ``exponent``, ``prefactor``: of the law
    that they should come to; ``fitted``: the exponent of the last few."""

    places: Array
    values: Array
    exponent: float
    prefactor: float
    fitted: float

    @property
    def ratios(self) -> Array:
        """Of the values over the law's."""
        return np.asarray(self.values / (self.prefactor * self.places**self.exponent))

    @property
    def off(self) -> float:
        """The fitted exponent's difference from the law's."""
        return abs(self.fitted - self.exponent)

    @property
    def whole(self) -> float:
        """The exponent of all values."""
        return power(self.places, self.values)

    @property
    def prefactor_percent(self) -> float:
        """Difference of the last value from the law's (%), with its sign."""
        return float(100.0 * (self.ratios[-1] - 1.0))


def scaling_of(
    rows: Sequence[Row], place: str, value: str, exponent: float, prefactor: float
) -> Scaling:
    """The scaling of a column with another, places in the rows' order; NaN where a march failed."""
    places, values = column(rows, place), column(rows, value)
    last = slice(-FITTED, None)
    known = np.all(values[last] > 0.0)
    fitted = power(places[last], values[last]) if known else np.nan
    return Scaling(places, values, exponent, prefactor, fitted)
