"""``task=simulate``: one simulation of one scene, with its trajectory and its figures."""

from collections.abc import Mapping
from typing import Any

from snapjump.declare.members import make_member
from snapjump.files.atomic import write_text
from snapjump.files.result_folder import ResultFolder
from snapjump.results import Result
from snapjump.run.tasks.base import (
    ERROR,
    NOT_FINITE,
    OK,
    SIMULATION,
    Outcome,
    Progress,
    Task,
    stretch,
)
from snapjump.run.tasks.complete import check_complete, warn_of_unusual
from snapjump.show.plots import figures
from snapjump.show.terminal.scene_report import scene_report
from snapjump.simulation import build, simulate
from snapjump.uncertainty.base import UncertaintyOptions

# Share of the progress bar for the simulation; the rest is for drawing.
SIMULATION_SHARE = 0.6
TABLE = "uncertainty.csv"


class Simulate(Task):
    """Builds the scene, simulates it, and again with what it may be off by, and draws what
    happened."""

    keys = (*SIMULATION, "uncertainty")

    def prepare(self, config: Mapping[str, Any]) -> None:
        self._config = config
        self._simulation = build(config)
        self._uncertainty: UncertaintyOptions = make_member(
            "uncertainty", config.get("uncertainty")
        )
        check_complete(config, self._simulation, uncertainty=self._uncertainty)
        warn_of_unusual(self._simulation)
        self._simulation.sim.check_start(self._simulation)
        self._uncertainty.check_for(self._simulation)

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        share = SIMULATION_SHARE if self._config["figures"] else 1.0
        result = simulate(self._simulation, stretch(progress, 0.0, share))
        summary = dict(result.summary)
        for each in self._simulation.sim.outputs.declared():
            if each.unknown and summary.get(each.name) != summary.get(each.name):  # NaN
                summary[each.name] = None
        outcome = Outcome(result.status, result.message, summary)
        try:
            summary |= self._off_by(result, folder)
            not_finite = folder.write_arrays("trajectory", result.arrays)
        except OSError as error:  # the numbers may find room where the arrays do not
            return Outcome(ERROR, f"{error.strerror}: the trajectory is not kept", summary)
        if not_finite and outcome.status == OK:
            outcome.status = NOT_FINITE
            outcome.message = "the trajectory is not finite in " + ", ".join(not_finite)
        if self._config["figures"] and not not_finite:
            drawn = stretch(progress, share, 1.0)
            folder.write_figures(lambda path: figures(result, path, drawn))
        return outcome

    def _off_by(self, result: Result, folder: ResultFolder) -> dict[str, Any]:
        """What the apex may be off by, which is left as a table too; nothing where there is none,
        or it is not asked for."""
        found = self._uncertainty.of(self._simulation) if result.status == OK else None
        if found is None:
            return {}
        write_text(folder.path / TABLE, found.csv())
        return found.summary()

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        return scene_report(self._config, outcome.summary)
