"""The answer to a problem: designs that reach its target, or the nearest apex that any reaches."""

import time
from dataclasses import dataclass

import numpy as np

from snapjump.arrays import Array
from snapjump.inverse.base import REACH_BAR, InverseOptions, Problem, Solution
from snapjump.robot.design import Design
from snapjump.targets.mirror import with_mirror


@dataclass(frozen=True, repr=False)
class Answer:
    """``solutions``: the best first, which is simulated; ``problem``: that with the bounds within
    which it was found.

    ``reachable``: whether its simulated apex is within 0.03 L of the target. False where no search
    on the simulator came as near, None where a method only asked the forward model, which decides
    nothing. ``searched`` (2, 2): least and largest delta_alpha (rad) and epsilon that were looked
    at; ``seconds``, ``simulations``: of the search.
    """

    reachable: bool | None
    solutions: list[Solution]
    problem: Problem
    searched: Array
    seconds: float
    simulations: int

    @property
    def best(self) -> Solution:
        """The solution whose simulated apex is the nearest."""
        return self.solutions[0]

    @property
    def design(self) -> Design:
        """Its design, for :func:`snapjump.simulate_jump`."""
        delta_alpha, epsilon = self.best.controls.tolist()
        return Design(epsilon=epsilon, delta_alpha=delta_alpha)

    @property
    def miss_bar(self) -> float:
        """Distance of its apex from the target, in L."""
        return self.best.miss_bar(self.problem.target)

    def __repr__(self) -> str:
        reached = {True: "reached", False: "unreachable", None: "not reached"}[self.reachable]
        (x, y), (apex_x, apex_y) = self.problem.target.tolist(), self.best.apex.tolist()
        design = f"epsilon {self.design.epsilon:.6g}, delta_alpha {self.design.delta_alpha:.6g} rad"
        came = f"apex {apex_x:.4g}, {apex_y:.4g} L, {self.miss_bar:.2g} L off"
        cost = f"{self.simulations} simulations, {self.seconds:.2g} s"
        return f"<target {x:g}, {y:g} L {reached}: {design}; {came}; {cost}>"


def answer(problem: Problem, method: InverseOptions) -> Answer:
    """Let a method search, on both sides of the symmetric robot, until a target is reached."""
    begun, before = time.perf_counter(), problem.simulator.simulations
    found: list[tuple[float, list[Solution], Problem]] = []
    for side in with_mirror(problem):
        solutions = simulated(side, method.solve(side))
        miss = solutions[0].miss_bar(problem.target)
        found.append((miss, solutions, side))
        if miss <= REACH_BAR:
            break
    least, solutions, where = min(found, key=lambda one: one[0])
    reachable = True if least <= REACH_BAR else None if method.needs_forward else False
    searched = np.array(
        [
            np.min([side.low for *_, side in found], axis=0),
            np.max([side.high for *_, side in found], axis=0),
        ]
    ).T
    seconds = time.perf_counter() - begun
    simulations = problem.simulator.simulations - before
    return Answer(reachable, solutions, where, searched, seconds, simulations)


def simulated(problem: Problem, solutions: list[Solution]) -> list[Solution]:
    """The solutions with that first which is the best by simulation.
    A predicted one is believed in its place if it is near enough, else all are compared."""
    if solutions[0].simulated:
        return solutions
    first = _simulated(problem, solutions[:1])
    if first[0].miss_bar(problem.target) > REACH_BAR and len(solutions) > 1:
        first += _simulated(problem, solutions[1:])
        first.sort(key=lambda one: one.miss_bar(problem.target))
    return first + solutions[len(first) :]


def _simulated(problem: Problem, solutions: list[Solution]) -> list[Solution]:
    controls = np.array([one.controls for one in solutions])
    apexes = problem.simulator.apexes(problem.designs(controls))
    # What does not jump gets nowhere.
    apexes = np.where(np.isfinite(apexes), apexes, np.inf)
    return [Solution(*pair, True) for pair in zip(controls, apexes, strict=True)]
