"""The contract of a plan: numbered designs, of which any stretch can be had on its own."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Range = tuple[float, float]


class Plan(Protocol):
    """Designs 0 to ``count`` - 1; the same numbers on every machine."""

    @property
    def count(self) -> int:
        """How many designs there are."""

    def designs(self, first: int, last: int) -> Array:
        """Designs first to last - 1, shape (last - first, I): a column for each of I ranges.

        Memory is in proportion to the stretch, never to ``count``. Raises ValueError for a
        stretch that is not within the plan.
        """


def check_stretch(first: int, last: int, count: int) -> None:
    """Raise ValueError unless 0 <= first <= last <= count."""
    if not 0 <= first <= last <= count:
        raise ValueError(f"designs {first} to {last} of a plan of {count}")


def stretched(unit: Array, ranges: tuple[Range, ...]) -> Array:
    """Points of the unit cube (N, I) in the box of the ranges."""
    low, high = np.array(ranges).T
    return low + (high - low) * unit
