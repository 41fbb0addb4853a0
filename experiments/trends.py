"""Trends of a curve: whether it is monotone, and where it levels off."""

from dataclasses import dataclass

import numpy as np

from snapjump.arrays import Array


def counter_step(values: Array, rising: bool) -> float:
    """The largest way back that the curve ever goes, as a share of all its change.
    0 for a monotone curve; 1 or more for one that ends no further than it has come back."""
    upward = values if rising else -values
    back = float(np.max(np.maximum.accumulate(upward) - upward))
    change = float(upward[-1] - upward[0])
    return back / change if change > 0.0 else np.inf


@dataclass(frozen=True)
class Plateau:
    """The ramp that fits a curve best: a straight line up to ``threshold``, a constant beyond.

    slope_before, slope_after: of straight lines through the curve's two parts; swing: from the
    lowest to the highest value beyond the threshold; level: their mean.
    """

    threshold: float
    slope_before: float
    slope_after: float
    swing: float
    level: float

    @property
    def levelling(self) -> float:
        """The slope beyond the threshold as a share of that before, without signs."""
        return abs(self.slope_after / self.slope_before)

    @property
    def relative_swing(self) -> float:
        """The swing as a share of the level."""
        return self.swing / abs(self.level)


LEAST = 5  # points on either side of a threshold


def plateau(places: Array, values: Array) -> Plateau:
    """The best ramp, its threshold at one of the places."""

    def misfit(k: int) -> float:
        ramp = np.stack([np.ones_like(places), np.minimum(places, places[k])], axis=1)
        return float(np.linalg.lstsq(ramp, values, rcond=None)[1].sum())

    best = min(range(LEAST - 1, len(places) - LEAST + 1), key=misfit)
    beyond = values[best:]
    return Plateau(
        float(places[best]),
        float(np.polyfit(places[: best + 1], values[: best + 1], 1)[0]),
        float(np.polyfit(places[best:], beyond, 1)[0]),
        float(np.ptp(beyond)),
        float(np.mean(beyond)),
    )
