"""One jump as the handful of numbers that convergence is judged by."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.ending.flight import FlightEnding
from snapjump.recorder.observables import make_observables
from snapjump.scenes.frame_body import frame_mesh
from snapjump.scenes.jump import jump_summary
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.resting import resting_guess
from snapjump.scenes.runner import March

Array = NDArray[np.float64]
# 150 bytes for each of them at most; untouched memory costs nothing.
MOST_STEPS = 4_000_000


def observe_jump(simulation: Simulation) -> dict[str, Any]:
    """Simulate a jump; its ``result.json`` figures and the observables.

    ``snap_time_s``: when the beam's middle passes the line of its mounts, from the beginning of
    the clamps' rotation; ``peak_force_N``: largest normal force of the ground on the robot;
    ``liftoff_speed_m_s``: of the centre of mass. NaN where there is none.
    """
    scales = simulation.robot.scales
    model = jump_model(simulation)
    march = March(
        models=[model],
        masses=simulation.discretization.masses(),
        states=resting_guess(simulation, model)[None, :],
        simulation=simulation,
        ending=FlightEnding(),
        recorder=make_observables(MOST_STEPS),
        mesh=frame_mesh(simulation, model.frame),
    )
    march.find_starts()
    outcome = march.run()[0]
    summary = jump_summary(simulation, model, outcome)
    recorder = march.recorder
    count = min(int(recorder.filled[0]), MOST_STEPS)
    times, heights = recorder.times[:count], recorder.heights[:count]
    begun = model.clamp.start / model.clamp.rate
    return {
        **summary,
        "snap_time_s": (crossing(times, heights) + begun) * scales.time_s,
        "peak_force_N": peak(times, recorder.forces[:count]) * scales.force_N,
        "liftoff_speed_m_s": float(np.hypot(summary["liftoff_vx_m_s"], summary["liftoff_vy_m_s"])),
        "kernel_seconds": march.kernel_seconds,
    }


def crossing(times: Array, values: Array) -> float:
    """When values first fall through zero: root of the cubic through the four nearest; or NaN."""
    from scipy.interpolate import BarycentricInterpolator
    from scipy.optimize import brentq

    fallen = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
    if len(fallen) == 0:
        return float("nan")
    k = int(fallen[0])
    near = slice(max(0, k - 1), k + 3)
    origin = times[k]
    cubic = BarycentricInterpolator(times[near] - origin, values[near])
    return float(origin + brentq(cubic, 0.0, times[k + 1] - origin, xtol=1e-15))


def peak(times: Array, values: Array) -> float:
    """The largest value, of the parabola through the three samples about it; NaN without any."""
    if len(values) == 0:
        return float("nan")
    k = int(np.argmax(values))
    if k in (0, len(values) - 1):
        return float(values[k])
    left, right = times[k - 1] - times[k], times[k + 1] - times[k]
    down, up = (values[k - 1] - values[k]) / left, (values[k + 1] - values[k]) / right
    bend = (up - down) / (right - left)
    slope = down - bend * left
    return float(values[k] - 0.25 * slope**2 / bend) if bend < 0.0 else float(values[k])
