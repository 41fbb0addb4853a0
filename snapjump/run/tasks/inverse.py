"""``task=inverse``: the design that reaches a target apex, and what is to be expected of it."""

import math
import sys
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from snapjump.backend.scalar import ScalarBackend
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.fields import construct
from snapjump.declare.members import make_member
from snapjump.files.result_folder import ResultFolder
from snapjump.files.sealed import file_sha256
from snapjump.inverse.base import InverseOptions, Solution
from snapjump.robot.design import Design
from snapjump.run.tasks.base import (
    NOT_REACHED,
    OK,
    SIMULATION,
    UNREACHABLE,
    Outcome,
    Progress,
    Task,
    stretch,
)
from snapjump.run.tasks.complete import check_complete, warn_of_unusual
from snapjump.show.plots.inverse import inverse_picture
from snapjump.show.terminal.inverse_report import inverse_report
from snapjump.simulation import build, simulate
from snapjump.targets import request
from snapjump.targets.answer import answer
from snapjump.targets.design import problem_of
from snapjump.targets.designed import Designed
from snapjump.targets.manufacturing import one_percent_costs
from snapjump.targets.region import AchievableRegion
from snapjump.targets.robust import Tolerance, compare
from snapjump.targets.simulator import differentiable
from snapjump.targets.warm_up import warm_up

# Shares of the progress bar that are done as the search, the simulation and the drawing begin.
SEARCHING, SIMULATING, DRAWING = 0.1, 0.6, 0.8
DRAWN_POINTS = 81  # of the region in the figure, per control


class InverseDesign(Task):
    """Decides, searches, simulates what was found, and draws it."""

    keys = (*SIMULATION, "inverse", "target", "checkpoint", "tolerance")

    def prepare(self, config: Mapping[str, Any]) -> None:
        self._config = config
        self._target = request.checked_target(config.get("target"))
        self._method: InverseOptions = make_member("inverse", config.get("inverse"))
        self._tolerance: Tolerance = construct("tolerance", Tolerance, config.get("tolerance"))
        path = request.checkpoint_path(config.get("checkpoint"))
        scene = config["sim"].get("name")
        if scene != "jump":
            raise ParameterError("sim", scene, "jump, which is what has an apex")
        self._base = build(config)
        check_complete(config, self._base, inverse=self._method, tolerance=self._tolerance)
        warn_of_unusual(self._base)
        self._base.sim.check_start(self._base)
        if self._method.needs_slopes:
            differentiable(self._base)
        self._trained = request.trained_forward(path)
        self._forward, self._warning = request.usable_forward(
            self._base, self._trained, self._method
        )

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        if self._warning:
            print(f"warning: {self._warning}", file=sys.stderr)
        problem = problem_of(
            self._base, self._target, self._trained, self._forward, self._config["seed"]
        )
        progress(0.0, "getting ready")
        warm_up(self._base, self._trained, self._method)
        progress(SEARCHING, "searching")
        found = answer(problem, self._method)
        chosen, robust = found.solutions[0], None
        if self._method.robust and found.problem.forward is not None and found.reachable:
            robust = compare(found.problem, self._tolerance, found.solutions)
            chosen = robust.robust
        built = self._designed(chosen)
        costs = one_percent_costs(built)
        # With its trajectory, by the program for one robot.
        alone = replace(built, backend=ScalarBackend())
        jump = simulate(alone, stretch(progress, SIMULATING, DRAWING))
        designed = Designed(found, chosen, costs, jump, robust, self._trained.about, self._warning)
        if self._config["figures"]:
            progress(DRAWING, "drawing")
            self._draw(folder, designed)
        return outcome_of(designed)

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        return inverse_report(self._config, outcome.summary)

    def reads(self, config: Mapping[str, Any]) -> dict[str, str]:
        own = {"checkpoint": file_sha256(request.checkpoint_path(config.get("checkpoint")))}
        return {**super().reads(config), **own}

    def _designed(self, chosen: Solution) -> Simulation:
        """The simulation of a design."""
        delta_alpha, epsilon = chosen.controls.tolist()
        return replace(self._base, design=Design(epsilon=epsilon, delta_alpha=delta_alpha))

    def _draw(self, folder: ResultFolder, designed: Designed) -> None:
        problem, region = designed.problem, None
        if problem.forward is not None:
            region = AchievableRegion.of(problem, problem.forward, DRAWN_POINTS)
        folder.write_figures(lambda path: inverse_picture(designed, region, path / "inverse.png"))


def outcome_of(designed: Designed) -> Outcome:
    """The outcome of a designed jump."""
    summary, jump, found = designed.summary(), designed.jump, designed.answer
    if found.reachable:
        if jump.status != OK:
            return Outcome(jump.status, f"the design that was found: {jump.message}", summary)
        return Outcome(OK, "", summary)
    x, y = found.solutions[0].apex.tolist()
    (least, largest), (loosest, tightest) = found.searched.tolist()
    searched = (
        f"in {found.simulations} simulations with delta_alpha in [{least:g}, {largest:g}] rad and "
        f"epsilon in [{loosest:g}, {tightest:g}]"
    )
    nearest = f"the nearest simulated apex is x {x:.4g} L, y {y:.4g} L"
    if found.reachable is None:
        told = f"{nearest} by the forward model's designs (inverse=physics searches on)"
        return Outcome(NOT_REACHED, told, summary)
    if not math.isfinite(x):
        return Outcome(UNREACHABLE, f"no design was found that jumps at all, {searched}", summary)
    told = f"no design was found that reaches the target, {searched}; {nearest}"
    return Outcome(UNREACHABLE, told, summary)
