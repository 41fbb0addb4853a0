"""One method on a few problems: designs, and what they really reach."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from scipy.stats.qmc import Sobol

from snapjump.arrays import Array
from snapjump.batch import simulate_designs
from snapjump.composition import Simulation
from snapjump.declare.members import make_member
from snapjump.inverse.base import CONTROLS, Problem, Solution
from snapjump.learning.forward_model import ForwardModel, forward_model
from snapjump.plan.base import Range, stretched
from snapjump.run.studies.base import Row
from snapjump.targets.answer import answer
from snapjump.targets.design import problem_of
from snapjump.targets.designed import point
from snapjump.targets.simulator import JumpSimulator
from snapjump.targets.warm_up import warm_up

from ..compositions import composed
from ..designs import COLUMNS
from .methods import LENGTH_MM, SOLVED_MM, TIERS

# Designs about one that missed its target, and the share of the controls' ranges they lie within.
AROUND, WITHIN = 64, 2.0e-3

opened = cache(forward_model)


class Problems(NamedTuple):
    """``hidden`` (N, 4): designs as everywhere; ``targets`` (N, 2): where they get to, in L."""

    hidden: Array
    targets: Array


def make_problems(
    base: Simulation, ranges: tuple[Range, ...], seed: int, first: int, last: int
) -> Problems:
    """Problems first to last - 1 of a seed; the same whichever others are asked for.
    Raises RuntimeError if a hidden design does not jump, for then its target is none."""
    unit = np.array([np.random.default_rng([seed, k]).random(4) for k in range(first, last)])
    hidden = stretched(unit, ranges)
    batch = simulate_designs(base, hidden, threads=1)
    targets = np.column_stack([batch.x_bar, batch.y_bar])
    if not all(status == "ok" for status in batch.status):
        raise RuntimeError(f"hidden designs failed: {sorted(set(batch.status))}")
    return Problems(hidden, targets)


def solve_block(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each problem of a cell: misses in mm, time, simulations.

    Misses are judged at the tier of the run (``own``), at standard and at reference.
    """
    forward, base = opened(inputs["checkpoint"]), composed(inputs["groups"])
    first, last = inputs["first"], inputs["last"]
    problems = make_problems(base, forward.ranges, inputs["seed"], first, last)
    method = make_member("inverse", inputs["inverse"])
    warm_up(base, forward, method)
    at_reference = inputs["inverse"].get("finishing") == "reference"
    rows: list[Row] = []
    for number, target, hidden in zip(
        range(first, last), problems.targets, problems.hidden, strict=True
    ):
        problem = make_problem(target, hidden, forward, base, number)
        found = answer(problem, method)
        row = {"problem": number, **answered(hidden, found.problem, found.solutions[0])}
        row |= {key: getattr(found, key) for key in ("reachable", "seconds", "simulations")}
        rows.append({**row, "finished_at": "reference" if at_reference else "own"})
    designs = np.array([[row[column] for column in COLUMNS] for row in rows])
    judge = JumpSimulator(base)
    judges = {"own": judge, **{tier: judge.at(tier) for tier in TIERS}}
    for tier, simulator in judges.items():
        for row, miss in zip(rows, misses_mm(simulator, designs, problems.targets), strict=True):
            row[f"miss_{tier}_mm"] = float(miss) if np.isfinite(miss) else None
    if inputs["inverse"]["name"] == "physics":
        for row, design, target in zip(rows, designs, problems.targets, strict=True):
            finished = row["finished_at"]
            if (row[f"miss_{finished}_mm"] or np.inf) >= SOLVED_MM:
                row["nearest_around_mm"] = nearest_around(judges[finished], design, target, forward)
    return rows


def misses_mm(simulator: JumpSimulator, designs: Array, targets: Array) -> Array:
    """Simulated distances (mm) between the apexes of designs and their targets."""
    misses: Array = np.hypot(*(simulator.apexes(designs) - targets).T) * LENGTH_MM
    return misses


def nearest_around(simulator: JumpSimulator, design: Array, target: Array, forward: Any) -> float:
    """The least miss (mm) of many designs about one that does not hit its target.
    If it is no smaller than that one's own, the map jumps over the target there."""
    low, high = np.array(forward.ranges).T
    offsets = 2.0 * Sobol(2, rng=0).random(AROUND) - 1.0
    designs = np.tile(design, (AROUND, 1))
    designs[:, :2] += WITHIN * (high - low)[:2] * offsets
    designs = np.clip(designs, low, high)
    return float(np.nanmin(misses_mm(simulator, designs, target)))


def make_problem(
    target: Array, hidden: Array, forward: ForwardModel, base: Any, seed: int
) -> Problem:
    """The problem whose environment is that of the hidden design."""
    environment = replace(base.environment, mass_bar=float(hidden[2]), mu=float(hidden[3]))
    here = replace(base, environment=environment)
    return problem_of(here, target, forward, forward, seed)


def answered(hidden: Array, problem: Problem, solution: Solution) -> Row:
    """Target, hidden design, answer and predicted apex as columns of a row."""
    forward, design = problem.known_forward("benchmark"), problem.designs(solution.controls[None])
    return {
        **point("target", problem.target),
        "mass_bar": problem.mass_bar,
        "mu": problem.mu,
        **{f"hidden_{name}": float(v) for name, v in zip(CONTROLS, hidden[:2], strict=True)},
        **dict(zip(CONTROLS, solution.controls.tolist(), strict=True)),
        **point("predicted", forward.predict(design)[0]),
    }
