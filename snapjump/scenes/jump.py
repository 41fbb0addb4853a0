"""The jump: from the static start through snap and strike to the ballistic apex."""

import math
import time
from typing import Any

import numpy as np

from snapjump.composition import Simulation
from snapjump.ending.flight import FlightEnding
from snapjump.engine import clock as c
from snapjump.engine.status import NAMES, NO_JUMP, OK, REASONS
from snapjump.error_estimate import error_estimate
from snapjump.options.backend import ScalarBackend
from snapjump.recorder.none import NoRecorder
from snapjump.recorder.trajectory import make_recorder
from snapjump.results import Result
from snapjump.scenes.card_march import check_backend, march_on
from snapjump.scenes.flight import flight
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.frame_body import frame_mesh
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.resting import resting_guess
from snapjump.scenes.runner import Progress
from snapjump.scenes.trajectory import trajectory_arrays


def simulate_jump_scene(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Simulate one jump with its whole trajectory and energy ledger.

    With ``backend=lanes`` and ``backend=cuda`` the program for batches is used, which gives
    outcomes only.
    """
    check_backend(simulation)
    begun = time.perf_counter()
    scales = simulation.robot.scales
    model = jump_model(simulation)
    state = resting_guess(simulation, model)
    duration = model.time_limit.duration
    interval = simulation.sim.sample_interval_s / scales.time_s
    alone = isinstance(simulation.backend, ScalarBackend)
    march = march_on(simulation)(
        models=[model],
        masses=simulation.discretization.masses(),
        states=state[None, :],
        simulation=simulation,
        ending=FlightEnding(),
        recorder=make_recorder(len(state), duration, interval) if alone else NoRecorder(),
        lanes=1 if alone else simulation.backend.width,
        mesh=frame_mesh(simulation, model.frame),
    )
    march.find_starts()
    outcome = march.run(progress)[0]
    outcome[c.STATUS] = checked_status(model, float(march.masses.sum()), outcome)
    arrays: dict[str, Any] = {}
    if alone and march.recorder.filled[0] > 0:
        arrays = trajectory_arrays(simulation, model, march)
    summary = jump_summary(simulation, model, outcome)
    if not alone:
        del summary["max_residual"]  # only recorded marches measure it
    summary["kernel_seconds"] = march.kernel_seconds
    summary["wall_seconds"] = time.perf_counter() - begun
    return Result(
        NAMES[int(outcome[c.STATUS])],
        jump_message(simulation, outcome),
        summary,
        arrays,
        simulation,
    )


def jump_message(simulation: Simulation, outcome: Any) -> str:
    """Why and when a jump did not end with an apex, or nothing."""
    status = int(outcome[c.STATUS])
    if status == OK:
        return ""
    time_ms = 1e3 * outcome[c.TIME] * simulation.robot.scales.time_s
    return f"{REASONS[status]} ({time_ms:.4g} ms after the start)"


def jump_summary(simulation: Simulation, model: Any, outcome: Any) -> dict[str, Any]:
    """The figures of result.json; times count from the beginning of the clamps' rotation.

    Without an apex (any status but ok and no_jump) its figures are NaN, and null in files.
    """
    scales = simulation.robot.scales
    flown = flight(model.clamp.start / model.clamp.rate, model.load.acceleration, outcome)
    status = int(outcome[c.STATUS])
    flew = status == OK
    nothing = math.nan
    known = status in (OK, NO_JUMP)
    estimate = error_estimate(simulation, outcome[c.ERROR_SUM], 1.0 / model.frame.mass)
    return {
        "status": NAMES[status],
        "x_bar": float(flown.apex_x) if known else nothing,
        "y_bar": float(flown.apex_y) if known else nothing,
        "apex_time_s": float(flown.apex_time) * scales.time_s if flew else nothing,
        "liftoff_time_s": float(flown.liftoff_time) * scales.time_s if flew else nothing,
        "liftoff_vx_m_s": float(flown.liftoff_vx) * scales.velocity_m_s if flew else nothing,
        "liftoff_vy_m_s": float(flown.liftoff_vy) * scales.velocity_m_s if flew else nothing,
        "mount_height_m": (model.frame.mount_y - model.frame.foot_y) * scales.length_m,
        "start_angle_rad": model.clamp.start,
        "steps": int(outcome[c.STEPS]),
        "rejected_steps": int(outcome[c.REJECTED]),
        "newton_iterations": int(outcome[c.ITERATIONS]),
        "min_gap_m": float(outcome[c.SMALLEST_GAP]) * scales.length_m
        if np.isfinite(outcome[c.SMALLEST_GAP]) and outcome[c.STEPS] > 0
        else nothing,
        "max_residual": float(outcome[c.LARGEST_RESIDUAL]),
        "accuracy": simulation.accuracy,
        "x_error_estimate_percent": float(estimate.x_percent) if known else nothing,
        "y_error_estimate_percent": float(estimate.y_percent) if known else nothing,
        "error_estimate_percent": float(estimate.percent) if known else nothing,
        "within_tier": known and bool(estimate.within_tier),
    }
