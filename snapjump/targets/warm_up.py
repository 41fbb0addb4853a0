"""Warm-up: kernels compiled and loaded, networks asked for the first time."""

import numpy as np

from snapjump.composition import Simulation
from snapjump.inverse.base import ForwardModel, InverseOptions, Problem
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.targets.answer import answer
from snapjump.targets.simulator import JumpSimulator


def warm_up(base: Simulation, forward: ForwardModel, method: InverseOptions) -> None:
    """Warm up for a search."""
    middle = np.mean(forward.ranges, axis=1)[None, :]
    simulator = JumpSimulator(base)
    low, high = np.array(forward.ranges[:2]).T
    target, (mass_bar, mu) = forward.predict(middle)[0], middle[0, 2:].tolist()
    problem = Problem(target, mass_bar, mu, low, high, forward, simulator)
    answer(problem, method if method.needs_forward else GaussNewtonOptions())
    if method.needs_slopes:
        simulator.slopes(middle)
