"""``sim=jump``: the whole jump: snap, strike, lift-off and ballistic apex."""

import time
from typing import Any

from snapjump.composition import Simulation
from snapjump.declare.fields import Need, number
from snapjump.engine.recorder.trajectory import recorder_of
from snapjump.results import Result
from snapjump.scenes.card_march import check_backend
from snapjump.scenes.compile_ahead import compile_ahead
from snapjump.scenes.every_step import ROWS, EveryStep
from snapjump.scenes.jump_march import jump_march, jumped, no_recorder
from snapjump.scenes.jump_outputs import JumpRun, RecordedJump
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.trajectory import trajectory_arrays
from snapjump.sim.base import TURNS, Progress, SceneOptions, check_samples


class Jump(SceneOptions):
    """The whole jump: snap, strike, lift-off and ballistic apex.

    The motion starts from the static solution at ``start_fraction`` of the symmetric arch's
    critical angle, flat by default; ``time_limit_s`` counts from that angle. States are kept
    ``sample_interval_s`` apart.
    """

    moves_a_beam = True
    tells = ("design.epsilon", "design.delta_alpha", "environment.mu", "environment.mass_bar")
    outputs = RecordedJump
    needs = (Need("frame", "flies"), Need("contact", "pushes"), TURNS)

    start_fraction: float = number(0.0, least=0.0, most=0.95)
    time_limit_s: float = number(0.1, above=0.0, unit="s")
    sample_interval_s: float = number(2.0e-5, above=0.0, unit="s")

    def check_with(self, simulation: Any) -> None:
        simulation.environment.mass_kg(simulation.robot)
        environment = simulation.environment
        environment.check_slope(0.0 if simulation.friction.absent else environment.mu)

    def check_start(self, simulation: Simulation) -> None:
        check_backend(simulation)
        if simulation.backend.one_at_a_time:
            compile_ahead(simulation)
        model = jump_model(simulation)
        if simulation.backend.one_at_a_time:
            limit_s = model.time_limit.duration * simulation.robot.scales.time_s
            check_samples(limit_s, self.sample_interval_s, simulation.discretization.elements)

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        """One jump with its whole trajectory and energy ledger.

        With ``backend=lanes`` and ``backend=cuda`` the program for batches is used, which gives
        outcomes only.
        """
        check_backend(simulation)
        begun = time.perf_counter()
        alone = simulation.backend.one_at_a_time
        if alone:
            compile_ahead(simulation)
        model, time_s = jump_model(simulation), simulation.robot.scales.time_s
        recorder = (lambda size: recorder_of(size, ROWS)) if alone else no_recorder
        march = jump_march([simulation], [model], recorder=recorder, lanes=simulation.backend.width)
        march.find_starts()
        steps = EveryStep(march, march.recorder, self.sample_interval_s / time_s) if alone else None
        known = simulation, begun, *jumped(march, progress), march.kernel_seconds
        if steps is None:
            return JumpRun(*known).result({})
        arrays = trajectory_arrays(march, steps.samples()) if steps.kept else {}
        return RecordedJump(*known, arrays, every=steps).result(arrays)
