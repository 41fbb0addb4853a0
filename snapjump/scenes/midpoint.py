"""The midpoint of a beam that snaps, at every step of its march."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.recorder.midpoint import CHORD_X, CHORD_Y, HEIGHT, SPEED, MidpointRecorder
from snapjump.scenes.between_steps import at, crossing, falls, peak, vertices
from snapjump.units import Scales

STRAIGHT = 1e-6  # of the length


@dataclass(frozen=True)
class Midpoint:
    """Of K steps, the first one the start, none where the march did not begin: times (s), heights
    over the line of the clamps (m), vertical velocities (m/s) and tangent angles (rad).
    ``straight_m``: what a beam that has not buckled may rise by rounding."""

    time_s: Array
    height_m: Array
    velocity_m_s: Array
    tilt_rad: Array
    straight_m: float

    @classmethod
    def of(cls, recorder: MidpointRecorder, scales: Scales) -> "Midpoint":
        """What a march has recorded."""
        count = int(recorder.filled[0])
        figures = recorder.figures[:count].T
        return cls(
            recorder.times[:count] * scales.time_s,
            figures[HEIGHT] * scales.length_m,
            figures[SPEED] * scales.velocity_m_s,
            np.unwrap(np.arctan2(figures[CHORD_Y], figures[CHORD_X])),
            STRAIGHT * scales.length_m,
        )

    @cached_property
    def crossing_s(self) -> float:
        """When it first passes the line of the clamps from above; NaN if it does not, or if the
        beam was straight."""
        arch = len(self.height_m) > 0 and self.height_m[0] > self.straight_m
        return crossing(self.time_s, self.height_m) if arch else float("nan")

    @cached_property
    def half_way_s(self) -> float:
        """When it passes half its initial height, last before the line; NaN if it does not."""
        before = slice(0, self._last_above + 2)
        above_half = self.height_m[before] - 0.5 * self.height_m[:1]
        return crossing(self.time_s[before], above_half, which=-1)

    @cached_property
    def turning_s(self) -> float:
        """When it first turns upwards below the line, or the end if it does not until then; NaN if
        it does not pass the line."""
        if np.isnan(self.crossing_s):
            return float("nan")
        below = self._last_above + 1
        rising = below + np.flatnonzero(np.diff(self.height_m[below:]) > 0.0)[:1]
        if len(rising) == 0:
            return float(self.time_s[-1])
        return float(vertices(self.time_s, -self.height_m, rising)[0][0])

    @property
    def _last_above(self) -> int:
        """The last step above the line before it is passed; -1 if it is not."""
        fallen = falls(self.height_m)
        return int(fallen[0]) if len(fallen) else -1

    def velocity_at(self, moment_s: float) -> float:
        """Its vertical velocity (m/s) at a moment, NaN at none."""
        return at(self.time_s, self.velocity_m_s, moment_s) if moment_s == moment_s else moment_s

    @property
    def lowest_m(self) -> float:
        """Its lowest height."""
        return -peak(self.time_s, -self.height_m)

    @property
    def largest_tilt_rad(self) -> float:
        """Its largest absolute tangent angle."""
        return max(peak(self.time_s, self.tilt_rad), peak(self.time_s, -self.tilt_rad))
