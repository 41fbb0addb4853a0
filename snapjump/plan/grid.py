"""Every combination of evenly spaced values."""

from dataclasses import dataclass

import numpy as np

from snapjump.plan.base import Array, Range, check_stretch


@dataclass(frozen=True)
class GridPlan:
    """``points`` values on each axis, its ends among them; the last axis runs fastest."""

    ranges: tuple[Range, ...]
    points: int

    @property
    def count(self) -> int:
        return int(self.points ** len(self.ranges))

    def designs(self, first: int, last: int) -> Array:
        check_stretch(first, last, self.count)
        places = np.unravel_index(np.arange(first, last), (self.points,) * len(self.ranges))
        axes = [np.linspace(low, high, self.points) for low, high in self.ranges]
        return np.stack([axis[place] for axis, place in zip(axes, places, strict=True)], axis=1)
