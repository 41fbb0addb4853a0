"""Options of the backends."""

import os
from dataclasses import dataclass

from snapjump.checks import ParameterError, check_integer

WIDTHS = (2, 4, 8, 16)
MOST_THREADS = 1024


def available_cores() -> int:
    """The cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@dataclass(frozen=True)
class ScalarBackend:
    """One robot at a time, with its whole trajectory."""


@dataclass(frozen=True)
class LanesBackend:
    """Robots side by side in the lanes of SIMD instructions: for batches, outcomes only.

    ``width`` robots in each of ``threads``; None: as many threads as there are cores to use.
    """

    width: int = 8
    threads: int | None = None

    def __post_init__(self) -> None:
        if type(self.width) is not int or self.width not in WIDTHS:
            raise ParameterError("backend.width", self.width, "one of 2, 4, 8, 16")
        if self.threads is not None:
            check_integer("backend.threads", self.threads, 1, MOST_THREADS)

    @property
    def thread_count(self) -> int:
        """Threads that a batch is simulated with."""
        return available_cores() if self.threads is None else self.threads
