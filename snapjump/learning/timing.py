"""Time of a prediction."""

import time
from collections.abc import Callable

import numpy as np

WARM_UP, CALLS = 20, 300


def microseconds(ask: Callable[[], object]) -> float:
    """Median time of a call, in us, after some that do not count."""
    times = []
    for call in range(WARM_UP + CALLS):
        started = time.perf_counter()
        ask()
        if call >= WARM_UP:
            times.append(time.perf_counter() - started)
    return 1e6 * float(np.median(times))
