"""The dynamic snap of the beam alone: a fixed frame, no gravity, no ground."""

import math
import time
from typing import Any

import numpy as np

from snapjump.clamp.smooth_start import SmoothStart
from snapjump.composition import Simulation
from snapjump.ending.timed import TimedEnding
from snapjump.engine import clock as c
from snapjump.engine.model import Model
from snapjump.engine.status import NAMES, OK, REASONS
from snapjump.frame.fixed import FixedFrame
from snapjump.load.none import NoLoad
from snapjump.recorder.trajectory import make_recorder
from snapjump.results import Result
from snapjump.scenes.runner import March, Progress
from snapjump.scenes.trajectory import trajectory_arrays
from snapjump.statics.arch import StaticArch


def simulate_snap_scene(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Turn the clamps of the arch at rest from flat and follow it through the snap."""
    begun = time.perf_counter()
    robot, scene = simulation.robot, simulation.sim
    scales = robot.scales
    arch = StaticArch(robot, simulation.discretization, simulation.design.epsilon)
    lag = simulation.design.delta_alpha
    state = arch.flat(lag)
    model = Model(
        discretization=simulation.discretization.beam(robot),
        frame=FixedFrame.Body(0.5 * (1.0 - simulation.design.epsilon), 0.0),
        clamp=SmoothStart(
            start=0.0,
            end=robot.rotation_end_rad,
            rate=robot.rotation_rate_rad_s * scales.time_s,
            delta_alpha=lag,
            rise_time=scene.rise_time_s / scales.time_s,
        ),
        contact=simulation.contact.law(scales),
        friction=simulation.friction.law(scales, simulation.environment.mu),
        damping=simulation.damping.law(scales),
        load=NoLoad(),
    )
    duration = scene.duration_s / scales.time_s
    march = March(
        models=[model],
        masses=simulation.discretization.masses(),
        states=state[None, :],
        simulation=simulation,
        ending=TimedEnding(duration),
        recorder=make_recorder(len(state), duration, scene.sample_interval_s / scales.time_s),
    )
    outcome = march.run(progress)[0]
    arrays = trajectory_arrays(simulation, model, march)
    status = int(outcome[c.STATUS])
    summary = {"status": NAMES[status], **snap_summary(arrays)}
    summary |= {
        "steps": int(outcome[c.STEPS]),
        "rejected_steps": int(outcome[c.REJECTED]),
        "newton_iterations": int(outcome[c.ITERATIONS]),
        "max_residual": float(outcome[c.LARGEST_RESIDUAL]),
        "accuracy": simulation.accuracy,
        "kernel_seconds": march.kernel_seconds,
        "wall_seconds": time.perf_counter() - begun,
    }
    when = f" ({1e3 * outcome[c.TIME] * scales.time_s:.4g} ms after the start)"
    message = "" if status == OK else REASONS[status] + when
    return Result(NAMES[status], message, summary, arrays, simulation)


def snap_summary(arrays: dict[str, Any]) -> dict[str, Any]:
    """When and how the midpoint crosses the line of the clamps; NaN if it does not.

    ``snap_duration_s`` runs from the crossing of half the initial height to the first extreme
    below; ``theta_max_rad`` is the largest absolute tangent angle at the midpoint.
    """
    x, y, t = arrays["node_x_m"], arrays["node_y_m"], arrays["time_s"]
    last = y.shape[1] - 1
    before, after = (last - 1) // 2, last // 2 + 1
    if last % 2 == 0:
        before, after = last // 2 - 1, last // 2 + 1
    height = 0.5 * (y[:, last // 2] + y[:, (last + 1) // 2])
    tangent = np.arctan2(y[:, after] - y[:, before], x[:, after] - x[:, before])
    below = np.flatnonzero(height < 0.0)
    summary = {
        "alpha_snap_rad": math.nan,
        "snap_time_s": math.nan,
        "midpoint_velocity_m_s": math.nan,
        "snap_duration_s": math.nan,
        "theta_max_rad": float(np.abs(tangent).max()),
        "midpoint_min_m": float(height.min()),
    }
    if len(below) == 0 or below[0] == 0:
        return summary
    k = int(below[0])
    share = height[k - 1] / (height[k - 1] - height[k])
    left = arrays["clamp_left_rad"]
    rising = np.flatnonzero(np.diff(height[k:]) > 0.0)
    turn = k + (int(rising[0]) if len(rising) else len(height) - 1 - k)
    begin = int(np.flatnonzero(height[: k + 1] > 0.5 * height[0])[-1])
    speeds = 0.5 * (arrays["node_vy_m_s"][:, last // 2] + arrays["node_vy_m_s"][:, (last + 1) // 2])
    summary |= {
        "alpha_snap_rad": float(left[k - 1] + share * (left[k] - left[k - 1])),
        "snap_time_s": float(t[k - 1] + share * (t[k] - t[k - 1])),
        "midpoint_velocity_m_s": float(speeds[k - 1] + share * (speeds[k] - speeds[k - 1])),
        "snap_duration_s": float(t[turn] - t[begin]),
    }
    return summary
