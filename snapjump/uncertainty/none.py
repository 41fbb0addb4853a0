"""``uncertainty=none``: nothing is simulated for it."""

from typing import Any

from snapjump.declare.scenes import Progress
from snapjump.uncertainty.base import UncertaintyOptions


class NoUncertainty(UncertaintyOptions):
    """None: the numerical error alone is told."""

    def of(self, simulation: Any, progress: Progress | None = None) -> None:
        return None
