"""Progress of many jumps in words: how many are done, their rate, and the time that remains."""

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
    """Turns shares of a group's jumps into shares of all of them, and into words.

    ``done``: of the ``total``, before it begins. The rate counts from the first time that jumps are
    told: not while kernels are compiled.
    """

    def __init__(
        self, total: int, tell: Progress, clock: Callable[[], float] = time.monotonic, done: int = 0
    ) -> None:
        self._total, self._tell, self._clock = total, tell, clock
        self._finished = done
        self._begun: tuple[float, int] | None = None

    def starts(self, count: int) -> Progress:
        """The progress of finding the starts of ``count`` jumps."""

        def told(share: float, _: str) -> None:
            found = f"{round(share * count)} of {count}"
            self._tell(self._finished / self._total, f"finding starts: {found}")

        return told

    def jumps(self, count: int) -> Progress:
        """The progress of the march of ``count`` jumps."""
        return lambda share, _: self.show(round(share * count))

    def show(self, under_way: int = 0) -> None:
        """Tell, with so many jumps done beside those that are finished."""
        done, now = self._finished + under_way, self._clock()
        self._begun = self._begun or (now, done)
        seconds, more = now - self._begun[0], done - self._begun[1]
        text = f"{done} of {self._total} jumps"
        if more > 0 and seconds > 0.0:
            remaining = seconds * (self._total - done) / more
            text += f", {more / seconds:.3g} jumps/s, {duration(remaining)} left"
        self._tell(done / self._total, text)

    def finish(self, count: int) -> None:
        self._finished += count
