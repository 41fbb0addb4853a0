"""The answer to a problem: designs that reach its target, or the nearest apex that any reaches."""

import time
from dataclasses import dataclass

import numpy as np

from snapjump.inverse import base
from snapjump.inverse.base import ForwardModel, InverseOptions, Problem, Solution
from snapjump.inverse.gauss_newton import descend
from snapjump.targets.region import AchievableRegion

# How far beyond the region's boundary (L) a method may still try: what the forward model's error
# makes of a boundary. The largest miss that counts as reached, too.
BOUNDARY_BAR = 0.03
ITERATIONS = 30


@dataclass(frozen=True)
class Answer:
    """``solutions``: the best first; of a target out of reach the design of the nearest apex alone.

    ``reachable``: whether the best one gets as near to the target as 0.03 L, by what it believes.
    ``seconds``: of the decision and the search; ``simulations``: that they took.
    """

    reachable: bool
    solutions: list[Solution]
    seconds: float
    simulations: int


def answer(problem: Problem, method: InverseOptions) -> Answer:
    """Decide whether the target is in the achievable region, and let a method search if it is.
    Without a forward model the method alone decides."""
    begun, before = time.perf_counter(), problem.simulator.simulations
    nearest = None if problem.forward is None else out_of_reach(problem, problem.forward)
    solutions = method.solve(problem) if nearest is None else [nearest]
    reachable = nearest is None and solutions[0].miss_bar(problem.target) <= BOUNDARY_BAR
    seconds = time.perf_counter() - begun
    return Answer(reachable, solutions, seconds, problem.simulator.simulations - before)


def out_of_reach(problem: Problem, forward: ForwardModel) -> Solution | None:
    """The design of the nearest apex for a target that no design reaches, otherwise None."""
    region = AchievableRegion.of(problem, forward)
    if region.contains(problem.target[None, :])[0]:
        return None
    # The grid's own error is taken out by a descent from where it is nearest.
    start = np.array([region.nearest(problem.target)[0]])
    controls, _ = descend(problem, forward, start, ITERATIONS)
    (nearest,) = base.predicted_solutions(problem, forward, controls)
    return None if nearest.miss_bar(problem.target) <= BOUNDARY_BAR else nearest
