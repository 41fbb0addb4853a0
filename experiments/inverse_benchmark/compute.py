"""One method on a few problems: designs, and what they really reach."""

import time
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.inverse_benchmark.methods import LENGTH_MM
from experiments.inverse_benchmark.problems import Array, make_problems
from experiments.inverse_benchmark.table import TIERS
from snapjump.inverse.base import Problem, Solution
from snapjump.learning.forward_model import ForwardModel, open_forward_model
from snapjump.members import make_member
from snapjump.studies.base import Row
from snapjump.targets.simulator import JumpSimulator
from snapjump.targets.warm_up import warm_up

opened = cache(open_forward_model)


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
    rows = []
    for k, (target, hidden) in enumerate(zip(problems.targets, problems.hidden, strict=True)):
        problem = make_problem(target, hidden, forward, base, first + k)
        begun = time.perf_counter()
        solution = method.solve(problem)[0]
        seconds = time.perf_counter() - begun
        rows.append(
            {
                "problem": first + k,
                **answered(hidden, problem, solution, forward),
                "seconds": seconds,
                "simulations": problem.simulator.simulations,
                "finished_at": "reference" if at_reference else "own",
            }
        )
    designs = np.array([[r["delta_alpha_rad"], r["epsilon"], r["mass_bar"], r["mu"]] for r in rows])
    judge = JumpSimulator(base)
    for tier in ("own", *TIERS):
        simulator = judge if tier == "own" else judge.at(tier)
        misses = np.hypot(*(simulator.apexes(designs) - problems.targets).T) * LENGTH_MM
        for row, miss in zip(rows, misses, strict=True):
            row[f"miss_{tier}_mm"] = float(miss) if np.isfinite(miss) else None
    return rows


def make_problem(
    target: Array, hidden: Array, forward: ForwardModel, base: Any, seed: int
) -> Problem:
    """The problem whose environment is that of the hidden design."""
    low, high = np.array(forward.ranges).T
    return Problem(
        target=target,
        mass_bar=float(hidden[2]),
        mu=float(hidden[3]),
        low=low[:2],
        high=high[:2],
        forward=forward,
        simulator=JumpSimulator(base),
        seed=seed,
    )


def answered(hidden: Array, problem: Problem, solution: Solution, forward: ForwardModel) -> Row:
    """What was asked, what was found, and what the forward model says of it."""
    delta_alpha, epsilon = (float(value) for value in solution.controls)
    predicted = forward.predict(problem.designs(solution.controls[None]))[0]
    return {
        "target_x_bar": float(problem.target[0]),
        "target_y_bar": float(problem.target[1]),
        "mass_bar": problem.mass_bar,
        "mu": problem.mu,
        "hidden_delta_alpha_rad": float(hidden[0]),
        "hidden_epsilon": float(hidden[1]),
        "delta_alpha_rad": delta_alpha,
        "epsilon": epsilon,
        "predicted_x_bar": float(predicted[0]),
        "predicted_y_bar": float(predicted[1]),
    }
