"""``task=simulate``: one simulation of one scene, with its trajectory and its figures."""

from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import TYPE_CHECKING, Any

from snapjump.checks import ParameterError
from snapjump.declare.fields import settings
from snapjump.files.result_folder import ResultFolder
from snapjump.tasks.base import NOT_FINITE, OK, Outcome, Progress

if TYPE_CHECKING:
    from snapjump.simulation import Result, Simulation

# Share of the progress bar for the simulation; the rest is for drawing.
SIMULATION_SHARE = 0.6


class Simulate:
    """Builds the scene, simulates it and draws what happened."""

    def __init__(self) -> None:
        self._config: Mapping[str, Any] = {}
        self._simulation: Simulation | None = None

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

        assert self._simulation is not None, "prepare comes first"
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


def check_complete(config: Mapping[str, Any], simulation: object, **others: Any) -> None:
    """Raise ParameterError for a key that was deleted: config.yaml tells everything.

    ``others``: options beside the simulation's, by their groups.
    """
    for group, values in config.items():
        options = others.get(group, getattr(simulation, group, None))
        for key in settings(options) if is_dataclass(options) else ():
            if key not in values:
                raise ParameterError(f"{group}.{key}", None, "a value, which cannot be left out")


def _draw(result: "Result", folder: ResultFolder, progress: Progress) -> None:
    from snapjump.plots import figures

    folder.write_figures(lambda path: figures(result, path, progress))
