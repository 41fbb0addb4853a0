"""The error estimate of a jump's apex, on which its flag ``within_tier`` rests.

The error of the time steps is the sum A of their own estimates (L) times a factor of the method,
levelling off where results no longer have anything in common but their range; the error of the
mesh is a power of the element's length. Both laws, and their numbers, are fits to measured errors
(``python run.py task=stability`` shows them): such that at least 95 % of the true errors are below
twice the estimate. Errors of x are relative to max(|x|, 0.1 y), those of y to y; in percent.
"""

from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array, Flags
from snapjump.composition import Simulation
from snapjump.number.portable import power
from snapjump.tiers import TIERS

# Percent of x per L of summed estimates, with fixed and with adaptive steps.
FACTORS = {
    "tr_bdf2": (1.8e4, 7.5e3),
    "sdirk2": (9.0e4, 4.0e4),
    "implicit_euler": (9.0e3, 9.0e3),
    "implicit_midpoint": (6.0e4, 6.0e4),
    "esdirk3": (5.0e4, 5.0e4),
    "esdirk4": (5.0e4, 5.0e4),
    "bdf2": (3.0e4, 3.0e4),
    "newmark": (5.0e4, 5.0e4),
    "generalized_alpha": (1.6e4, 1.6e4),
}
UNKNOWN = (9.0e4, 9.0e4)  # of a method that has not been measured
LEVEL = 50.0  # percent of x that unrelated results differ by
STEPS_Y = 0.12  # error of y over that of x that steps make
BASE_ELEMENTS = 104.0
MESH_X, MESH_Y = (0.12, 2.8), (0.07, 2.8)  # percent at BASE_ELEMENTS, and order
# Two fixed nodes for a clamp are of first order.
TWO_NODES = (3.0, 1.0)
# Without material damping waves that a mesh does not resolve run on: its errors are so much larger.
UNDAMPED, LITTLE_DAMPING = 3.0, 2.28e-4  # T
# A frame that is light against its beam shakes with it: all errors grow by this share of the
# ratio of their masses.
LIGHT_FRAME = 0.1


class ErrorEstimate(NamedTuple):
    """Estimated errors of x and y (%), and whether both are within the accuracy tier's promise."""

    x_percent: Array
    y_percent: Array
    within_tier: Flags

    @property
    def percent(self) -> Array:
        """The larger of both."""
        return np.maximum(self.x_percent, self.y_percent)


def steps_factor(simulation: Simulation) -> float:
    """Percent of x per L of summed estimates."""
    fixed, adaptive = FACTORS.get(simulation.integrator.name, UNKNOWN)
    return fixed if simulation.stepping.name == "fixed" else adaptive


def mesh_percent(discretization: Any, relaxation: Any) -> tuple[Any, Any]:
    """Errors of x and y that the mesh makes (%) of beams so much damped."""
    ratio = BASE_ELEMENTS / discretization.elements
    waves = np.where(np.asarray(relaxation) >= LITTLE_DAMPING, 1.0, UNDAMPED)
    x, y = (waves * value * power(ratio, order) for value, order in (MESH_X, MESH_Y))
    if getattr(discretization, "clamp", "") == "two_nodes":
        value, order = TWO_NODES
        extra = value * power(ratio, order)
        x, y = x + extra, y + extra
    return x, y


def error_estimate(
    simulation: Simulation, error_sum: Any, beam_over_frame: Any, relaxation: Any
) -> ErrorEstimate:
    """The estimate of jumps whose steps' estimates add up to ``error_sum`` (L).

    ``beam_over_frame``: mass of the beam over that of the frame, of each; ``relaxation``: its
    material's time (T).
    """
    light = 1.0 + LIGHT_FRAME * np.asarray(beam_over_frame)
    steps = light * steps_factor(simulation) * np.asarray(error_sum, dtype=float)
    steps = steps / (1.0 + steps / LEVEL)
    mesh_x, mesh_y = mesh_percent(simulation.discretization, relaxation)
    x, y = steps + light * mesh_x, STEPS_Y * steps + light * mesh_y
    promise = TIERS[simulation.accuracy].promise_percent
    return ErrorEstimate(x, y, np.maximum(x, y) <= promise)
