"""What a batch tells of its progress: jumps done, their rate, and the time that remains."""

import time
from collections.abc import Callable

from snapjump.declare.scenes import Progress


def duration(seconds: float) -> str:
    """A duration for people: two units at most."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"


class BatchProgress:
    """Turns shares of a group's jumps into shares of all of them, and into words."""

    def __init__(
        self, total: int, tell: Progress, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._total = total
        self._tell = tell
        self._clock = clock
        self._begun: tuple[float, int] | None = None
        self._finished = 0

    def starts(self, count: int) -> Progress:
        """The progress of finding the starts of ``count`` jumps."""

        def told(share: float, _: str) -> None:
            found = f"{round(share * count)} of {count}"
            self._tell(self._finished / self._total, f"finding starts: {found}")

        return told

    def jumps(self, count: int) -> Progress:
        """The progress of the march of ``count`` jumps.

        The rate counts from the first time that anything is told: not while kernels are compiled.
        """

        def told(share: float, _: str) -> None:
            done = self._finished + round(share * count)
            now = self._clock()
            self._begun = self._begun or (now, done)
            seconds, more = now - self._begun[0], done - self._begun[1]
            text = f"{done} of {self._total} jumps"
            if more > 0 and seconds > 0.0:
                remaining = seconds * (self._total - done) / more
                text += f", {more / seconds:.3g} jumps/s, {duration(remaining)} left"
            self._tell(done / self._total, text)

        return told

    def finish(self, count: int) -> None:
        self._finished += count
