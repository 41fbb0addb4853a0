"""What errors of one percent in building a robot, or in knowing where it will jump, cost."""

import numpy as np

from snapjump.checks import ParameterError
from snapjump.inverse.base import Array, Problem, Solution, one_percent_bar


def one_percent_costs_bar(problem: Problem, solution: Solution) -> Array:
    """How far (L) one percent of each of a solution's parameters moves its apex: (4,).

    By the simulator's exact derivatives for a solution that was simulated, if it has them, else by
    the forward model's; NaN where neither knows. Order: delta_alpha, epsilon, mass_bar, mu.
    """
    design = problem.designs(solution.controls[None, :])
    if solution.simulated or problem.forward is None:
        try:
            costs = one_percent_bar(design, problem.simulator.slopes(design))[0]
        except ParameterError:  # modules that sensitivities do not know
            costs = np.full(4, np.nan)
        if np.isfinite(costs).all() or problem.forward is None:
            return costs
    return one_percent_bar(design, problem.forward.jacobian(design))[0]
