"""A snap of the beam alone, kept step by step.

The library's scene keeps books of energy at every sample, which take a second a snap where every
step is to be kept; sweeps of the midpoint's motion do without.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.engine import outcome as c
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.status import NAMES, REASONS
from snapjump.scenes.snap_march import snap_march
from snapjump.scenes.trajectory import samples_of

Array = NDArray[np.float64]
INTERVAL = 2e-3  # T: below the fixed step of the paper, and the steps of a snap at standard
MOST_SAMPLES = 60_000  # many times the steps of any snap, in memory that is there


@dataclass(frozen=True)
class Swing:
    """S samples of the N + 1 nodes x, y (in L, from the middle of the clamps), their vertical
    velocities (m/s) and times (s, from the start of the clamps); ``unit_s``: the beam's T."""

    status: str
    time_s: Array
    x: Array
    y: Array
    speed_m_s: Array
    clamp: Any
    unit_s: float

    @property
    def height(self) -> Array:
        """Of the midpoint over the clamps (S,), in L."""
        return self._middle(self.y)

    @property
    def midpoint_speed_m_s(self) -> Array:
        """Upward (S,)."""
        return self._middle(self.speed_m_s)

    @property
    def tangent_rad(self) -> Array:
        """At the midpoint (S,): over the two elements that meet there, or the middle one."""
        last = self.y.shape[1] - 1
        before, after = (last - 1) // 2, last // 2 + 1
        rise = self.y[:, after] - self.y[:, before]
        return np.arctan2(rise, self.x[:, after] - self.x[:, before])

    def left_rad(self, time_s: float) -> float:
        """The left clamp's angle."""
        return float(self.clamp.angles(time_s / self.unit_s).left)

    def _middle(self, values: Array) -> Array:
        last = values.shape[1] - 1
        return 0.5 * (values[:, last // 2] + values[:, (last + 1) // 2])


def follow(simulation: Simulation) -> Swing:
    """Turn the clamps of the arch at rest from flat, for the duration of ``sim=snap``.

    Raises ArithmeticError where there is no such arch.
    """
    scales = simulation.robot.scales
    kept = min(simulation.sim.duration_s / scales.time_s, MOST_SAMPLES * INTERVAL)
    march = snap_march(simulation, lambda size, steps: make_recorder(size, kept, INTERVAL))
    outcome = march.run()[0]
    if march.recorder.filled[0] == 0:
        raise ArithmeticError(REASONS[int(outcome[c.STATUS])])
    times, states, velocities, _ = samples_of(march, march.recorder)
    if len(times) > MOST_SAMPLES:
        raise RuntimeError(f"a snap of more than {MOST_SAMPLES} steps")
    stride = march.models[0].discretization.node_dofs()
    return Swing(
        status=NAMES[int(outcome[c.STATUS])],
        time_s=times * scales.time_s,
        x=states[:, 0::stride],
        y=states[:, 1::stride],
        speed_m_s=velocities[:, 1::stride] * scales.velocity_m_s,
        clamp=march.models[0].clamp,
        unit_s=scales.time_s,
    )


def crossing(swing: Swing) -> int | None:
    """The first sample with the midpoint below the clamps."""
    below = np.flatnonzero(swing.height < 0.0)
    return int(below[0]) if len(below) and below[0] > 0 else None


def lowest(swing: Swing, crossed: int) -> int:
    """The sample where the midpoint first comes to rest below: the end of the snap."""
    rising = np.flatnonzero(np.diff(swing.height[crossed:]) > 0.0)
    return crossed + int(rising[0]) if len(rising) else len(swing.height) - 1


def sinking(swing: Swing, crossed: int, count: int) -> list[int]:
    """So many samples, from rest to the midpoint's lowest place, between which it sinks by equal
    steps."""
    height = swing.height[: lowest(swing, crossed) + 1]
    levels = np.linspace(height[0], height[-1], count)
    return [int(np.flatnonzero(height <= level)[0]) for level in levels]


def outcome(swing: Swing) -> dict[str, Any]:
    """A snap in numbers; null where there is none.

    ``theta_max_rad``: the largest absolute tangent angle at the midpoint until the snap ends;
    ``theta_later_rad``: the same with the vibration that follows; ``theta_rest_rad``: before the
    clamps turn; ``snap_duration_ms``: from half the height at rest to the lowest point.
    """
    tangent, height, time = np.abs(swing.tangent_rad), swing.height, swing.time_s
    row: dict[str, Any] = {"status": swing.status, "theta_rest_rad": float(tangent[0])}
    k = crossing(swing)
    if k is None:
        return row | dict.fromkeys(
            ("theta_max_rad", "theta_later_rad", "alpha_snap_rad", "snap_time_ms",
             "midpoint_velocity_m_s", "snap_duration_ms")
        )  # fmt: skip
    end = lowest(swing, k)

    def at_crossing(values: Array) -> float:
        return float(np.interp(0.0, -height[k - 1 : k + 1], values[k - 1 : k + 1]))

    begin = int(np.flatnonzero(height[: k + 1] > 0.5 * height[0])[-1])
    moment = at_crossing(time)
    return row | {
        "theta_max_rad": float(tangent[: end + 1].max()),
        "theta_later_rad": float(tangent.max()),
        "alpha_snap_rad": swing.left_rad(moment),
        "snap_time_ms": 1e3 * moment,
        "midpoint_velocity_m_s": at_crossing(swing.midpoint_speed_m_s),
        "snap_duration_ms": 1e3 * float(time[end] - time[begin]),
    }
