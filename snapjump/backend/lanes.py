"""``backend=lanes``: robots side by side in the lanes of SIMD instructions, in several threads."""

from snapjump.backend.base import MOST_THREADS, WIDTHS, BackendOptions
from snapjump.declare.fields import choice, integer
from snapjump.files.cores import own_cores


class LanesBackend(BackendOptions):
    """Robots side by side in the lanes of SIMD instructions: for batches, outcomes only.
    ``width`` robots in each of ``threads``; None: as many threads as there are cores to use."""

    width: int = choice(8, WIDTHS)
    threads: int | None = integer(None, least=1, most=MOST_THREADS)

    @property
    def thread_count(self) -> int:
        return len(own_cores()) if self.threads is None else self.threads
