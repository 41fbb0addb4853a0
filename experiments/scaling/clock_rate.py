"""Cycles a second of a core, by a chain of integer operations that take one cycle each.

None of them has a constant: some processors add those in no time, as they rename registers.
"""

import statistics
import time
from collections.abc import Callable

from numba import njit

ROUNDS, STEPS = 5, 50_000_000
SHORT_ROUNDS, SHORT_STEPS = 25, 1_000_000
CYCLES = 2  # of a step: a sum and an exclusive or, each waiting for the one before


@njit(cache=True)
def chain(steps: int) -> int:
    """What a compiler cannot shorten."""
    value = 0
    for k in range(steps):
        value = (value + k) ^ k
    return value


def cycles_per_microsecond() -> float:
    """The median of several rounds."""
    chain(1)
    seconds = []
    for _ in range(ROUNDS):
        begun = time.thread_time()
        chain(STEPS)
        seconds.append(time.thread_time() - begun)
    return 1e-6 * CYCLES * STEPS / statistics.median(seconds)


def cycles_of(call: Callable[[], object]) -> float:
    """Cycles that a call takes: the median of several rounds, each beside the chain, since the
    clock of a processor changes with its load."""
    chain(1)
    call()
    ratios = []
    for _ in range(SHORT_ROUNDS):
        begun = time.thread_time()
        chain(SHORT_STEPS)
        between = time.thread_time()
        call()
        ratios.append((time.thread_time() - between) / (between - begun))
    return CYCLES * SHORT_STEPS * statistics.median(ratios)
