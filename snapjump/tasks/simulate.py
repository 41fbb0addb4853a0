"""``task=simulate``: one simulation of one scene, with its trajectory and its figures."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from snapjump.files.result_folder import ResultFolder
from snapjump.tasks.base import NOT_FINITE, OK, Outcome, Progress
from snapjump.tasks.complete import check_complete

if TYPE_CHECKING:
    from snapjump.simulation import Result, Simulation

# Share of the progress bar for the simulation; the rest is for drawing.
SIMULATION_SHARE = 0.6


class Simulate:
    """Builds the scene, simulates it and draws what happened."""

    _config: Mapping[str, Any]
    _simulation: "Simulation"

    def prepare(self, config: Mapping[str, Any]) -> None:
        """Build the simulation, which checks every value; then that none was left out."""
        from snapjump.simulation import build

        self._config = config
        self._simulation = build(config)
        check_complete(config, self._simulation)
        self._simulation.sim.check_start(self._simulation)

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        """Simulate, and leave the trajectory and the figures."""
        from snapjump.simulation import simulate

        share = SIMULATION_SHARE if self._config["figures"] else 1.0
        result = simulate(self._simulation, lambda done, text: progress(share * done, text))
        outcome = Outcome(result.status, result.message, dict(result.summary))
        not_finite = folder.write_arrays("trajectory", result.arrays)
        if not_finite and outcome.status == OK:
            outcome.status = NOT_FINITE
            outcome.message = "the trajectory is not finite in " + ", ".join(not_finite)
        if self._config["figures"] and not not_finite:
            _draw(result, folder, lambda done, text: progress(share + (1 - share) * done, text))
        return outcome

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        """The closing block of this scene."""
        from snapjump.terminal.scene_report import scene_report

        return scene_report(self._config, outcome.summary)


def _draw(result: "Result", folder: ResultFolder, progress: Progress) -> None:
    from snapjump.plots import figures

    folder.write_figures(lambda path: figures(result, path, progress))
