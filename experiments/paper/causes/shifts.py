"""How far two settings' answers lie apart, over the same designs."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from experiments.errors import percentile, relative_errors
from experiments.paper.jumps import numbers
from snapjump.studies.base import Row


@dataclass(frozen=True)
class Shift:
    """Medians and 95th percentiles of the shift (%), x relative to max(|x|, 0.1 y); ``y_signed``:
    the median with its sign. A jump that failed counts as infinitely far."""

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
    """The shift from the base."""
    x, y, x0, y0 = (numbers(r, key) for r in (rows, base) for key in ("x_bar", "y_bar"))
    in_x, in_y = relative_errors(x, y, x0, y0)
    return Shift(
        percentile(in_x, 50.0),
        percentile(in_x, 95.0),
        percentile(in_y, 50.0),
        percentile(in_y, 95.0),
        float(np.nanmedian(100.0 * (y / y0 - 1.0))),
    )
