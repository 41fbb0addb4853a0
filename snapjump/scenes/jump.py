"""The jump: from the static start through snap and strike to the ballistic apex."""

import time

from snapjump.backend.scalar import ScalarBackend
from snapjump.composition import Simulation
from snapjump.ending.flight import FlightEnding
from snapjump.engine import clock as c
from snapjump.engine.status import NAMES, NO_JUMP, OK, REASONS
from snapjump.error_estimate import error_estimate
from snapjump.recorder.none import NoRecorder
from snapjump.recorder.trajectory import make_recorder
from snapjump.results import Result
from snapjump.scenes.card_march import check_backend, march_on
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.jump_outputs import JumpRun, RecordedJump
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.march_outputs import side_by_side
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
    duration = simulation.sim.time_limit_s / scales.time_s
    interval = simulation.sim.sample_interval_s / scales.time_s
    alone = isinstance(simulation.backend, ScalarBackend)
    march = march_on(simulation)(
        models=[model],
        masses=simulation.discretization.masses(),
        states=state[None, :],
        simulation=simulation,
        ending=FlightEnding(duration),
        recorder=make_recorder(len(state), duration, interval) if alone else NoRecorder(),
        lanes=1 if alone else simulation.backend.width,
        mesh=simulation.frame.mesh(model.frame),
    )
    march.find_starts()
    outcome = march.run(progress)
    side = side_by_side([model])
    outcome[:, c.STATUS] = checked_status(side, float(march.masses.sum()), outcome)
    kind = RecordedJump if alone else JumpRun
    outputs = kind(simulation, begun, side, outcome, march.kernel_seconds)
    recorded = alone and march.recorder.filled[0] > 0
    return outputs.result(trajectory_arrays(simulation, model, march) if recorded else {})
