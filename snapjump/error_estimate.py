"""The error estimate of a jump's apex, on which its flag ``within_tier`` rests.

The error of the time steps is the sum A of their own estimates (L) times a factor of the method,
levelling off where results no longer have anything in common but their range; the error of the
mesh is a power of the element's length. Both grow with what makes a robot hard: a light frame, a
tall one, little damping, fast clamps, much friction, low clamps. The numbers are fits to true
errors of robots far beyond the paper's ranges too (``python -m experiments.claims``), such that
95 % of these are below twice the estimate; where robots or members were not calibrated
(:mod:`snapjump.calibrated`) there is none. Errors of x are relative to max(|x|, 0.1 y), those of y
to y; in percent.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array
from snapjump.calibrated import (
    against_throw,
    beam_over_frame,
    frame_height,
    friction,
    members_factor,
    mount_height,
    rate,
    relaxation,
    unknown_because,
)
from snapjump.composition import Simulation
from snapjump.number.portable import power, powers
from snapjump.tiers import TIERS

# Percent of x per L of summed estimates, with fixed and with adaptive steps.
FACTORS = {
    "generalized_alpha": (360.0, 130.0),
    "tr_bdf2": (1.1e3, 290.0),
    "sdirk2": (1.4e4, 950.0),
    "esdirk3": (1.8e4, 1.4e3),
    "esdirk4": (1.8e4, 1.4e3),
    "bdf2": (500.0, 115.0),
    "newmark": (1.5e3, 7e3),
    "implicit_midpoint": (1.5e3, 5e3),
    "implicit_euler": (3e3, 100.0),
}
LEVEL = 50.0  # percent of x that unrelated results differ by
STEPS_Y = 0.25  # error of y over that of x that steps make
BASE_ELEMENTS = 120.0
MESH_X, MESH_Y, MESH_ORDER = 0.03, 0.021, 2.4  # percent at BASE_ELEMENTS, and order
# Two fixed nodes for a clamp are of first order.
TWO_NODES = (1.0, 1.0)
LEAST_RELAXATION = 1e-5  # T, below all that is known
# The share of its promise that an estimate may take: true errors scatter about it.
SURE = 0.45
# Of a recorded jump that keeps a promise. Of 430 robots beyond the paper's ranges that said so, at
# `standard`, numerics took at most 3 % of the energy, and Newton's method left 0.7 of the forces
# (and a true error of 0.02 %, which a residual tells little of).
LARGEST_LOSS = 0.1  # of the largest kinetic energy
LARGEST_RESIDUAL = 1.0  # over the largest force


class ErrorEstimate(NamedTuple):
    """Estimated errors of x and y (%), NaN where they are not known; whether both are within the
    accuracy tier's promise (True, False, or None where that is not known); why they are not known,
    empty if they are."""

    x_percent: Array
    y_percent: Array
    within_tier: NDArray[Any]
    because: NDArray[Any]

    @property
    def percent(self) -> Array:
        """The larger of both."""
        return np.maximum(self.x_percent, self.y_percent)

    def balanced(self, loss_share: float, residual: Array) -> "ErrorEstimate":
        """This, of a jump that does not keep its tier's promise with so much energy lost to the
        numerics, over the largest kinetic energy, or such a residual, over the largest force."""
        if not (abs(loss_share) > LARGEST_LOSS or np.any(residual > LARGEST_RESIDUAL)):
            return self
        told = [None if within is None else False for within in self.within_tier]
        return self._replace(within_tier=np.array(told, dtype=object))


def steps_factor(simulation: Simulation) -> float:
    """Percent of x per L of summed estimates; NaN for a method that has not been measured."""
    fixed, adaptive = FACTORS.get(simulation.integrator.name, (np.nan, np.nan))
    return fixed if simulation.stepping.name == "fixed" else adaptive


def mesh_percent(discretization: Any) -> tuple[Any, Any]:
    """Errors of x and y that the mesh makes (%)."""
    ratio = BASE_ELEMENTS / discretization.elements
    x, y = (value * power(ratio, MESH_ORDER) for value in (MESH_X, MESH_Y))
    if getattr(discretization, "clamp", "") == "two_nodes":
        value, order = TWO_NODES
        extra = value * power(ratio, order)
        x, y = x + extra, y + extra
    return x, y


def hardness(model: Any) -> Any:
    """Factor (R,) by which the errors of robots are larger than those of easy ones."""
    return (
        powers(1.0 + beam_over_frame(model) / 0.03, 0.66)
        * powers(1.0 + 1e-3 / np.maximum(relaxation(model), LEAST_RELAXATION), 0.63)
        * powers(1.0 + rate(model) / 0.1, 0.38)
        * powers(np.maximum(1.0, 1.0 / mount_height(model)), 0.9)
        * powers(np.maximum(1.0, frame_height(model) / 0.7), 0.7)
    )


def jamming(model: Any) -> Any:
    """Factor (R,) by which errors of the steps are larger where friction jams a foot."""
    return powers(1.0 + powers(np.maximum(friction(model), 0.1) / 0.66, 16.0), 0.6)


def cancelling(model: Any) -> Any:
    """Factor (R,) by which errors of x are larger where mismatch and the frame's centre of mass
    throw to opposite sides, so that x is a difference."""
    return np.maximum(1.0, against_throw(model) / 0.08)


def error_estimate(simulation: Simulation, model: Any, error_sum: Array) -> ErrorEstimate:
    """The estimate of R jumps whose steps' estimates add up to ``error_sum`` (R), in L.

    ``model``: their models side by side. A sum that is NaN has no estimate.
    """
    because = unknown_because(simulation, model)
    if not np.isfinite(steps_factor(simulation)):
        because = f"integrator={simulation.integrator.name} has not been calibrated"
    because = np.broadcast_to(because, error_sum.shape)
    known = (because == "") & np.isfinite(error_sum)
    x = y = np.full(error_sum.shape, np.nan)
    if known.any():
        factor = hardness(model) * members_factor(simulation)
        steps = factor * jamming(model) * steps_factor(simulation) * error_sum
        steps = steps / (1.0 + steps / LEVEL)
        mesh_x, mesh_y = mesh_percent(simulation.discretization)
        x = np.where(known, cancelling(model) * (steps + factor * mesh_x), np.nan)
        y = np.where(known, STEPS_Y * steps + factor * mesh_y, np.nan)
    promise = TIERS[simulation.accuracy].promise_percent
    sure = np.maximum(x, y) <= SURE * promise
    within: NDArray[Any] = np.where(known, sure, np.full(known.shape, None))
    return ErrorEstimate(x, y, within, because)
