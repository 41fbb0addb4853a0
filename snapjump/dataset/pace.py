"""How fast a dataset grows, and what remains."""

import time
from collections.abc import Callable

from snapjump.batch.progress import duration

Tell = Callable[[float, str], None]


class Pace:
    """Counts designs and tells a progress bar: how many, how fast, how long still."""

    def __init__(self, count: int, kept: int, tell: Tell):
        self.count, self.kept, self._tell = count, kept, tell
        self.made = 0
        self._begun = time.perf_counter()

    @property
    def seconds(self) -> float:
        """Since it began."""
        return time.perf_counter() - self._begun

    def show(self, under_way: float = 0.0) -> None:
        """Tell, with so many designs done of the shard under way."""
        made = self.made + under_way
        rate = made / max(self.seconds, 1e-9)
        left = self.count - self.kept - made
        text = f"{int(self.kept + made)} of {self.count} jumps"
        if made > 0:
            text += f", {rate:.3g}/s, {duration(left / rate)} left"
        self._tell((self.kept + made) / self.count, text)
