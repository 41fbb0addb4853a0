"""One method on a few problems: designs, and what they really reach."""

import time
from collections.abc import Mapping
from dataclasses import replace
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

opened = cache(open_forward_model)


def solve_block(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each problem of a cell: misses in mm at both tiers, time, simulations."""
    forward = opened(inputs["checkpoint"])
    base = composed(inputs["groups"])
    first, last = inputs["first"], inputs["last"]
    problems = make_problems(base, forward.ranges, inputs["seed"], first, last)
    method = make_member("inverse", inputs["inverse"])
    simulators = {tier: JumpSimulator(base).at(tier) for tier in TIERS}
    # Kernels are loaded before the clock starts.
    for simulator in simulators.values():
        simulator.apexes(problems.hidden[:1])
    rows = []
    for k in range(last - first):
        problem = make_problem(problems.targets[k], problems.hidden[k], forward, base, first + k)
        method.solve(problem) if k == 0 else None
        simulator = JumpSimulator(base)
        problem = replace(problem, simulator=simulator)
        begun = time.perf_counter()
        solution = method.solve(problem)[0]
        seconds = time.perf_counter() - begun
        rows.append(row(problems.hidden[k], problem, solution, forward, seconds))
        rows[-1] |= {
            "problem": first + k,
            "simulations": simulator.simulations,
            "finished_at": "reference" if inputs["inverse"].get("finishing") == "reference"
            else "standard",
        }  # fmt: skip
    designs = np.array([[r["delta_alpha_rad"], r["epsilon"], r["mass_bar"], r["mu"]] for r in rows])
    for tier, simulator in simulators.items():
        misses = np.hypot(*(simulator.apexes(designs) - problems.targets).T) * LENGTH_MM
        for one, miss in zip(rows, misses, strict=True):
            one[f"miss_{tier}_mm"] = float(miss) if np.isfinite(miss) else None
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


def row(
    hidden: Array, problem: Problem, solution: Solution, forward: ForwardModel, seconds: float
) -> Row:
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
        "seconds": seconds,
    }
