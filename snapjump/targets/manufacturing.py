"""Manufacturing errors: changes of the apex by one percent of each parameter."""

import numpy as np

from snapjump.inverse.base import Array, Problem, Solution

PERCENT = 0.01


def one_percent_costs_bar(problem: Problem, solution: Solution) -> Array:
    """Distances (4,) in L that one percent of each of a solution's parameters moves its apex by.

    Half the distance between the simulated apexes at 1 % more and at 1 % less; NaN where one of
    them does not jump. Order: delta_alpha, epsilon, mass_bar, mu. (An exact derivative is that of
    a wrinkle of the map, which is far narrower than what a workshop keeps.)
    """
    design = problem.designs(solution.controls[None, :])
    more, less = design * (1.0 + PERCENT * np.eye(4)), design * (1.0 - PERCENT * np.eye(4))
    apexes = problem.simulator.apexes(np.vstack([more, less]))
    found: Array = 0.5 * np.hypot(*(apexes[:4] - apexes[4:]).T)
    return found
