"""Options of the backends."""

import os

from snapjump.checks import ParameterError, check_integer
from snapjump.declare.fields import Part, integer, number

WIDTHS = (2, 4, 8, 16)
MOST_THREADS = 1024
WARP = 32  # threads of a card that march in step
LARGEST_BLOCK = 256  # whose threads still find registers


def available_cores() -> int:
    """The cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class BackendOptions(Part):
    """A backend and its numbers."""

    group = "backend"


class ScalarBackend(BackendOptions):
    """One robot at a time, with its whole trajectory."""


class LanesBackend(BackendOptions):
    """Robots side by side in the lanes of SIMD instructions: for batches, outcomes only.

    ``width`` robots in each of ``threads``; None: as many threads as there are cores to use.
    """

    width: int = 8
    threads: int | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if type(self.width) is not int or self.width not in WIDTHS:
            raise ParameterError("backend.width", self.width, "one of 2, 4, 8, 16")
        if self.threads is not None:
            check_integer("backend.threads", self.threads, 1, MOST_THREADS)

    @property
    def thread_count(self) -> int:
        """Threads that a batch is simulated with."""
        return available_cores() if self.threads is None else self.threads


class CudaBackend(BackendOptions):
    """One robot a thread of an NVIDIA card: for batches, outcomes only.

    As many robots at once as fit ``memory_gib`` of the card's memory, the others follow.
    """

    device: int = integer(0, least=0, most=1023)
    memory_gib: float = number(4.0, above=0.0, most=1024.0, unit="GiB")
    threads_per_block: int = 64

    def __post_init__(self) -> None:
        super().__post_init__()
        block = self.threads_per_block
        if type(block) is not int or block % WARP or not WARP <= block <= LARGEST_BLOCK:
            raise ParameterError(
                "backend.threads_per_block", block, f"a multiple of {WARP} up to {LARGEST_BLOCK}"
            )

    @property
    def width(self) -> int:
        """Robots side by side in a thread."""
        return 1

    @property
    def thread_count(self) -> int:
        """Threads of the processor."""
        return 1
