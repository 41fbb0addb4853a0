"""Time of a prediction."""

import timeit
from collections.abc import Callable

import numpy as np

WARM_UP, CALLS = 20, 300


def microseconds(ask: Callable[[], object]) -> float:
    """Median time of a call, in us, after some that do not count."""
    times = timeit.repeat(ask, number=1, repeat=WARM_UP + CALLS)
    return 1e6 * float(np.median(times[WARM_UP:]))
