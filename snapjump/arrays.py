"""Types of arrays, and the different rows of a table."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]


def distinct_rows(table: Array) -> tuple[Array, NDArray[np.int64]]:
    """The different rows (M, K) of a table (R, K), and which of them each row (R) is."""
    order = np.lexsort(table.T)
    ordered = table[order]
    new = np.ones(len(table), dtype=bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    places = np.empty(len(table), dtype=np.int64)
    places[order] = np.cumsum(new) - 1
    return ordered[new], places
