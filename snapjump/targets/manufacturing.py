"""What errors in building a robot, or in knowing where it will jump, cost."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import inputs_of, slope_names
from snapjump.uncertainty.parts.simulated import simulated_table
from snapjump.uncertainty.parts.tolerances import RELATIVE, Tolerance

PERCENT = 0.01
FIRST = "robot.thickness_m"  # whose cube is the beam's stiffness


@dataclass(frozen=True)
class OnePercent:
    """What one percent of an input moves an apex by: ``costs`` in L, by the input's name (the last
    word of its path), thickness first, then by size; NaN where the robot does not jump so.

    ``numerical_bar``: the apex's estimated numerical error (L), below which a cost says nothing;
    NaN where it is not known. ``because``: why there are no costs, empty if there are.
    """

    costs: dict[str, float]
    numerical_bar: float = np.nan
    because: str = ""


def one_percent_costs(simulation: Simulation) -> OnePercent:
    """How far one percent of each number of a robot, its design, environment and laws moves its
    apex: half the distance between the simulated apexes at 1 % more and at 1 % less.

    All but that number is as built (:mod:`snapjump.uncertainty.parts.as_built`); numbers that are 0
    or not given have no percent. (An exact derivative is that of a wrinkle of the map, which is far
    narrower than what a workshop keeps.)
    """
    known = inputs_of(simulation)
    names = dict(zip(known, slope_names([*known.values()]), strict=True))
    try:
        found = simulated_table(simulation, dict.fromkeys(known, Tolerance(RELATIVE, PERCENT)))
    except ParameterError as error:
        return OnePercent({}, because=str(error))
    costs = {one.name: one.half_distance for one in found.influences}
    order = sorted(costs, key=lambda path: (path != FIRST, -np.nan_to_num(costs[path])))
    numerical_bar = float(np.hypot(*found.numerical))
    return OnePercent({names[path]: costs[path] for path in order}, numerical_bar)


def alone_off(design: Sequence[float] | Array, factors: Sequence[float] | Array) -> Array:
    """A design (I,) with each of its numbers alone times each of F factors: (I F, I)."""
    made = np.tile(design, (len(design), len(factors), 1))
    for k in range(len(design)):
        made[k, :, k] *= factors
    found: Array = made.reshape(-1, len(design))
    return found


@dataclass(frozen=True)
class ErrorCurves:
    """``errors`` (F) of a parameter, relative; ``relative`` (I, F, 2): changes of x and y over x
    and y, for errors of each of I parameters alone. Elasticity: change for a small error, over
    it."""

    errors: Array
    relative: Array

    @classmethod
    def of(cls, apexes: Array, factors: Array) -> "ErrorCurves":
        """From apexes (I, F, 2) of the designs of :func:`alone_off`, one of its factors being 1."""
        right = int(np.abs(factors - 1.0).argmin())
        return cls(factors - 1.0, apexes / apexes[0, right] - 1.0)

    def at(self, error: float) -> Array:
        """Changes (I, 2) at an error that is among them."""
        (k,) = np.flatnonzero(np.isclose(self.errors, error, rtol=0.0, atol=1e-9))
        found: Array = self.relative[:, k]
        return found

    @property
    def largest(self) -> Array:
        """Largest changes (I, 2), whatever their sign."""
        found: Array = np.nanmax(np.abs(self.relative), axis=1)
        return found

    @property
    def trends(self) -> Array:
        """Elasticities (I, 2) of straight lines fitted to all errors."""
        return np.array([np.polyfit(self.errors, one, 1)[0] for one in self.relative])

    @property
    def roughness(self) -> float:
        """Mean size of the second differences of x along the curves, at every percent."""
        percents = 100.0 * self.errors
        every = np.isclose(percents, np.round(percents), rtol=0.0, atol=1e-6)
        return float(np.nanmean(np.abs(np.diff(self.relative[:, every, 0], 2, axis=1))))

    def secants(self, error: float) -> Array:
        """Elasticities (I, 2) between an error either way."""
        found: Array = (self.at(error) - self.at(-error)) / (2.0 * error)
        return found

    def deviations(self, elasticities: Array, error: float) -> Array:
        """How far (I, 2) straight lines of given elasticities are off at an error either way."""
        lines = [self.at(sign * error) - sign * error * elasticities for sign in (-1.0, 1.0)]
        found: Array = np.max(np.abs(lines), axis=0)
        return found
