"""The dynamic snap of the beam alone: a fixed frame, no gravity, no ground."""

import math
import time
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.composition import Simulation
from snapjump.declare.fields import number
from snapjump.declare.outputs import output
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.results import Result
from snapjump.scenes.march_outputs import RecordedOutputs, side_by_side
from snapjump.scenes.snap_march import snap_march
from snapjump.scenes.trajectory import trajectory_arrays
from snapjump.sim.base import NEEDS_NO_GROUND, WITHOUT_GROUND, Progress, SampledScene


@dataclass(frozen=True)
class SnapOutputs(RecordedOutputs):
    """When and how the midpoint crosses the line of the clamps; NaN if it does not.
    ``arrays``: the trajectory (S samples)."""

    arrays: dict[str, Any]

    @cached_property
    def height(self) -> Array:
        """Midpoint above the line of the clamps (S), in m."""
        return middle(self.arrays["node_y_m"])

    @cached_property
    def crossed(self) -> int:
        """The first sample below that line; 0 if it never gets there from above."""
        return int(np.argmax(self.height < 0.0))

    def at_crossing(self, values: Array) -> float:
        """The value, of samples (S), as the midpoint crosses the line."""
        k, height = self.crossed, self.height
        if k == 0:
            return math.nan
        share = height[k - 1] / (height[k - 1] - height[k])
        return float(values[k - 1] + share * (values[k] - values[k - 1]))

    @output("rad")
    def alpha_snap_rad(self) -> float:
        """Angle of the left clamp as the midpoint crosses the line of the clamps."""
        return self.at_crossing(self.arrays["clamp_left_rad"])

    @output("s")
    def snap_time_s(self) -> float:
        """When the midpoint crosses the line of the clamps, since they began to turn."""
        return self.at_crossing(self.arrays["time_s"])

    @output("m/s")
    def midpoint_velocity_m_s(self) -> float:
        """Vertical velocity of the midpoint as it crosses the line of the clamps."""
        return self.at_crossing(middle(self.arrays["node_vy_m_s"]))

    @output("s")
    def snap_duration_s(self) -> float:
        """From the crossing of half the initial height to the first extreme below the line."""
        k, height, t = self.crossed, self.height, self.arrays["time_s"]
        if k == 0:
            return math.nan
        rising = np.flatnonzero(np.diff(height[k:]) > 0.0)
        turn = k + (int(rising[0]) if len(rising) else len(height) - 1 - k)
        begin = int(np.flatnonzero(height[: k + 1] > 0.5 * height[0])[-1])
        return float(t[turn] - t[begin])

    @output("rad")
    def theta_max_rad(self) -> float:
        """Largest absolute tangent angle at the midpoint."""
        tangent = middle_angle(self.arrays["node_x_m"], self.arrays["node_y_m"])
        return float(np.abs(tangent).max())

    @output("m")
    def midpoint_min_m(self) -> float:
        """Lowest height of the midpoint."""
        return float(self.height.min())


def middle(values: Array) -> Array:
    """Values at the midpoint (S) from values (S, N + 1) at nodes."""
    last = values.shape[1] - 1
    return np.asarray(0.5 * (values[:, last // 2] + values[:, (last + 1) // 2]))


def middle_angle(x: Array, y: Array) -> Array:
    """Tangent angle (S) at the midpoint of nodes (S, N + 1): over the two elements that meet there,
    or over the middle one of an odd number."""
    last = y.shape[1] - 1
    before, after = (last + 1) // 2 - 1, last // 2 + 1
    return np.asarray(np.arctan2(y[:, after] - y[:, before], x[:, after] - x[:, before]))


class Snap(SampledScene):
    """The beam alone snaps in a frame that is held still, without gravity or ground.
    The clamps start from flat and reach their rate within about ``rise_time_s``."""

    moves_a_beam = True
    tells = ("design.epsilon", "design.delta_alpha")
    chooses = WITHOUT_GROUND
    outputs = SnapOutputs
    needs = NEEDS_NO_GROUND

    duration_s: float = number(0.06, above=0.0, unit="s")
    rise_time_s: float = number(1.0e-3, above=0.0, unit="s")
    sample_interval_s: float = number(5.0e-5, above=0.0, unit="s")

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        """Turn the clamps of the arch at rest from flat and follow it through the snap."""
        begun, time_s = time.perf_counter(), simulation.robot.scales.time_s
        duration, interval = self.duration_s / time_s, self.sample_interval_s / time_s
        march = snap_march(simulation, lambda size: make_recorder(size, duration, interval))
        outcome, model = march.run(progress), march.models[0]
        arrays = trajectory_arrays(model, march)
        side, seconds = side_by_side([model]), march.kernel_seconds
        return SnapOutputs(simulation, begun, side, outcome, seconds, arrays).result(arrays)
