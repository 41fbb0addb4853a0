"""A designed jump: the answer, its simulation, and the flat numbers of its ``result.json``."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.inverse.base import Problem, Solution
from snapjump.results import Result
from snapjump.targets.answer import Answer
from snapjump.targets.manufacturing import OnePercent
from snapjump.targets.robust import Comparison, Scatter


@dataclass(frozen=True)
class Designed:
    """``chosen``: the design; ``costs``: what 1 % of each input moves its apex by; ``jump``: its
    simulation; ``robust``: where a robust design was asked for; ``trained``: what the forward model
    says of itself; ``warning``: why it was not asked."""

    answer: Answer
    chosen: Solution
    costs: OnePercent
    jump: Result
    robust: Comparison | None
    trained: Mapping[str, Any]
    warning: str

    @property
    def problem(self) -> Problem:
        """The problem, with the bounds within which the design was found."""
        return self.answer.problem

    @property
    def predicted(self) -> Array | None:
        """Apex (2,) by the forward model, if there is one for this environment."""
        if self.problem.forward is None:
            return None
        designs = self.problem.designs(self.chosen.controls[None, :])
        return self.problem.forward.predict(designs)[0]

    @property
    def simulated(self) -> Array | None:
        """Apex (2,) by the simulator, if the robot jumped."""
        if self.jump.status != "ok":
            return None
        return np.array([self.jump.x_bar, self.jump.y_bar])

    def summary(self) -> dict[str, Any]:
        """Keys with their unit; None where there is no number."""
        problem, length_m = self.problem, self.jump.simulation.robot.length_m
        missed = None
        if self.simulated is not None:
            missed = float(np.hypot(*(self.simulated - problem.target)))
        found = {
            "reachable": self.answer.reachable,
            **point("target", problem.target),
            "mu": problem.mu,
            "mass_bar": problem.mass_bar,
            **controls("", self.chosen),
            "mount_height_bar": self.jump.summary.get("mount_height_bar"),
            **point("predicted", self.predicted),
            **point("simulated", self.simulated),
            **self._on_level(),
            "error_bar": missed,
            "error_m": None if missed is None else missed * length_m,
            "solve_seconds": self.answer.seconds,
            "simulations": self.answer.simulations,
            **bounds("delta_alpha_rad", self.answer.searched[0]),
            **bounds("epsilon", self.answer.searched[1]),
            "solutions": len(self.answer.solutions),
            "error_estimate_percent": self.jump.summary.get("error_estimate_percent"),
        }
        for k, other in enumerate(self.answer.solutions[1:], start=2):
            found |= controls(f"solution_{k}_", other)
            found[f"solution_{k}_simulated"] = other.simulated
        dataset = self.trained["dataset"]
        found |= {
            "forward_model": self.trained["surrogate"]["name"],
            "forward_model_dataset_sha256": dataset["sha256"],
            "forward_model_accuracy": dataset["specification"]["configuration"]["accuracy"]["name"],
            **({"warning": self.warning} if self.warning else {}),
        }
        for name, cost in self.costs.costs.items():
            known = np.isfinite(cost)
            found[f"one_percent_{name}_bar"] = cost if known else None
            found[f"one_percent_{name}_m"] = cost * length_m if known else None
        numerical = self.costs.numerical_bar
        found["numerical_error_bar"] = numerical if np.isfinite(numerical) else None
        if self.costs.because:
            found["one_percent_unknown_because"] = self.costs.because
        if self.robust is not None:
            found["robust_seconds"] = self.robust.seconds
            found |= controls("plain_", self.robust.plain)
            found |= spread("plain", self.robust.plain_scatter)
            found |= spread("robust", self.robust.robust_scatter)
        return found

    def _on_level(self) -> dict[str, Any]:
        """The slope, and the simulated apex on the level and along the plumb; nothing where the
        ground is level."""
        slope_rad = self.jump.simulation.environment.slope_rad
        if slope_rad == 0.0:
            return {}
        jump, flew = self.jump, self.simulated is not None
        place = np.array([jump.x_world_bar, jump.y_world_bar]) if flew else None
        return {"slope_rad": slope_rad, **point("level", place)}


def point(name: str, place: Array | None) -> dict[str, Any]:
    """Coordinates of an apex by their keys."""
    x, y = (None, None) if place is None else place.tolist()
    return {f"{name}_x_bar": x, f"{name}_y_bar": y}


def controls(prefix: str, solution: Solution) -> dict[str, Any]:
    """Controls of a solution by their keys."""
    delta_alpha, epsilon = solution.controls.tolist()
    return {f"{prefix}epsilon": epsilon, f"{prefix}delta_alpha_rad": delta_alpha}


def bounds(name: str, pair: Array) -> dict[str, float]:
    """The ends of a range that was searched, by their keys."""
    least, largest = pair.tolist()
    return {f"searched_{name}_least": least, f"searched_{name}_largest": largest}


def spread(name: str, scatter: Scatter) -> dict[str, Any]:
    """The distribution of a design's apex."""
    return {
        f"{name}_expected_miss_bar": scatter.expected_miss_bar,
        f"{name}_radius90_bar": scatter.radius90_bar,
        **point(f"{name}_mean", scatter.mean),
        **point(f"{name}_deviation", scatter.deviation),
    }
