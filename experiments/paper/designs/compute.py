"""Designs for a few targets by one method, and where they really get to."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from experiments.compositions import composed
from experiments.paper.learned import shipped_forward
from experiments.paper.settings import BASELINE, simulation_at
from snapjump.batch import simulate_designs, variant
from snapjump.declare.members import member_class
from snapjump.run.studies.base import Row
from snapjump.targets.answer import answer
from snapjump.targets.design import problem_of
from snapjump.targets.warm_up import warm_up

MASS_BAR, MU = BASELINE[2:]


class Case(NamedTuple):
    """A robot on a ground, and where it is to jump: the apex x, y in L."""

    label: str
    mass_bar: float
    mu: float
    x_bar: float
    y_bar: float


ONE_ROBOT = tuple(
    Case(f"{row}{column}", MASS_BAR, MU, x, y)
    for row, y in zip("ABC", (20.0, 16.0, 12.0), strict=True)
    for column, x in zip("123", (2.0, 3.5, 5.0), strict=True)
)
# The fourth and the fifth share their target.
MANY_ROBOTS = (
    Case("R1", 0.35, 0.5, 10.0, 40.0),
    Case("R2", 0.4, 0.3, 4.0, 45.0),
    Case("R3", 0.5, 0.3, 7.0, 30.0),
    Case("R4", 0.5, 0.15, 3.0, 22.0),
    Case("R5", 0.768, 0.45, 3.0, 22.0),
    Case("R6", 0.9, 0.6, 7.0, 14.0),
    Case("R7", 1.2, 0.2, 2.0, 13.0),
    Case("R8", 2.0, 0.3, 1.5, 8.0),
)
GROUPS: dict[str, tuple[Case, ...]] = {"one robot": ONE_ROBOT, "many robots": MANY_ROBOTS}
METHODS = ("adam", "gauss_newton", "physics")


def case_of(row: Any) -> Case:
    """A case from plain values in its order."""
    return Case(str(row[0]), *(float(value) for value in row[1:]))


LIFT_OFF = ("liftoff_x_bar", "liftoff_y_bar", "liftoff_vx_m_s")


def design_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each case: its design, what the forward model and each tier say of it (misses in
    mm), its lift-off at the first of them, time and simulations of the search."""
    base, forward = composed(inputs["groups"]), shipped_forward()
    method = member_class("inverse", inputs["method"])()
    warm_up(base, forward, method)
    cases = [case_of(values) for values in inputs["cases"]]
    rows: list[Row] = []
    designs, targets = np.zeros((len(cases), 4)), np.zeros((len(cases), 2))
    for k, case in enumerate(cases):
        targets[k] = case.x_bar, case.y_bar
        robot = variant(base, (*BASELINE[:2], case.mass_bar, case.mu))
        problem = problem_of(robot, targets[k], forward, forward, inputs["seed"])
        found = answer(problem, method)
        designs[k] = problem.designs(found.solutions[0].controls[None, :])[0]
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
    add_places(rows, "predicted", forward.predict(designs))
    length_mm = 1e3 * base.robot.length_m
    for tier in inputs["tiers"]:
        batch = simulate_designs(simulation_at(inputs["groups"], tier), designs, threads=2, lanes=8)
        add_places(rows, tier, batch.apexes)
        for row, miss in zip(rows, np.hypot(*(batch.apexes - targets).T), strict=True):
            row[f"miss_{tier}_mm"] = float(length_mm * miss)
        if tier == inputs["tiers"][0]:
            for row, left in zip(rows, batch.rows(*LIFT_OFF), strict=True):
                row |= left
    return rows


def add_places(rows: list[Row], name: str, apexes: Any) -> None:
    """Both coordinates (N, 2) of an apex in each row."""
    for row, (x, y) in zip(rows, apexes.tolist(), strict=True):
        row[f"{name}_x_bar"], row[f"{name}_y_bar"] = x, y
