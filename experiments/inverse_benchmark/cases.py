"""Designs for given robots, grounds and targets by one method, and where they really get to."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from snapjump.batch import simulate_designs, variant
from snapjump.composition import Simulation
from snapjump.run.studies.base import Row
from snapjump.targets.answer import answer
from snapjump.targets.design import problem_of
from snapjump.targets.warm_up import warm_up

from ..designs import BASELINE

LIFT_OFF = ("liftoff_x_bar", "liftoff_y_bar", "liftoff_vx_m_s")


class Case(NamedTuple):
    """A robot on a ground, and where it is to jump: the apex x, y in L."""

    label: str
    mass_bar: float
    mu: float
    x_bar: float
    y_bar: float


def case_rows(
    base: Simulation,
    forward: Any,
    method: Any,
    cases: Sequence[Case],
    judges: Mapping[str, Simulation],
    seed: int,
) -> list[Row]:
    """A row for each case: its design, what the forward model and each tier say of it (misses
    in mm), its lift-off at the first of them, time and simulations of the search."""
    warm_up(base, forward, method)
    targets = np.array([(case.x_bar, case.y_bar) for case in cases])
    rows: list[Row] = []
    designs, predicted = np.zeros((len(cases), 4)), np.zeros((len(cases), 2))
    for k, case in enumerate(cases):
        robot = variant(base, (*BASELINE[:2], case.mass_bar, case.mu))
        problem = problem_of(robot, targets[k], forward, forward, seed)
        found = answer(problem, method)
        designs[k] = problem.designs(found.solutions[0].controls[None, :])[0]
        predicted[k] = found.problem.known_forward("cases").predict(designs[k : k + 1])[0]
        rows.append(
            {
                "robot": case.label,
                "mass_bar": case.mass_bar,
                "mu": case.mu,
                "target_x_bar": case.x_bar,
                "target_y_bar": case.y_bar,
                "delta_alpha_rad": float(designs[k, 0]),
                "epsilon": float(designs[k, 1]),
                "reachable": found.reachable,
                "solutions": len(found.solutions),
                "seconds": found.seconds,
                "simulations": found.simulations,
            }
        )
    add_places(rows, "predicted", predicted)
    length_mm = 1e3 * base.robot.length_m
    for k, (tier, simulation) in enumerate(judges.items()):
        batch = simulate_designs(simulation, designs, threads=2, lanes=8)
        add_places(rows, tier, batch.apexes)
        for row, miss in zip(rows, np.hypot(*(batch.apexes - targets).T), strict=True):
            row[f"miss_{tier}_mm"] = float(length_mm * miss)
        if k == 0:
            for row, left in zip(rows, batch.rows(*LIFT_OFF), strict=True):
                row |= left
    return rows


def add_places(rows: list[Row], name: str, apexes: Any) -> None:
    """Both coordinates (N, 2) of an apex in each row."""
    for row, (x, y) in zip(rows, apexes.tolist(), strict=True):
        row[f"{name}_x_bar"], row[f"{name}_y_bar"] = x, y
