"""Relative changes of the apex, their slopes, and how far straight lines hold."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from experiments.paper.baseline import NAMES
from snapjump.studies.base import Done, Row

Array = NDArray[np.float64]
SECANT = 0.02  # error either way, several wrinkles of the map wide
SMALLEST = 1e-9  # difference of factors that are not the same


@dataclass(frozen=True)
class Changes:
    """Of one tier: ``errors`` (F) of a parameter, relative; ``apex`` (2,) without error, in L;
    ``relative`` (4, F, 2): changes of x and y over x and y, for errors of each parameter alone."""

    errors: Array
    apex: Array
    relative: Array

    def at(self, error: float) -> Array:
        """Changes (4, 2) at an error that is among them."""
        (k,) = np.flatnonzero(np.abs(self.errors - error) < SMALLEST)
        found: Array = self.relative[:, k]
        return found

    @property
    def largest(self) -> Array:
        """Largest changes (4, 2), whatever their sign."""
        found: Array = np.nanmax(np.abs(self.relative), axis=1)
        return found

    @property
    def secants(self) -> Array:
        """Elasticities (4, 2) between a small error either way."""
        found: Array = (self.at(SECANT) - self.at(-SECANT)) / (2.0 * SECANT)
        return found

    @property
    def trends(self) -> Array:
        """Elasticities (4, 2) of straight lines fitted to all errors."""
        known = [np.polyfit(self.errors, changes, 1)[0] for changes in self.relative]
        return np.array(known)

    def deviations(self, elasticities: Array, error: float) -> Array:
        """How far (4, 2) straight lines of given elasticities are off at an error either way."""
        off = [self.at(sign * error) - sign * error * elasticities for sign in (-1.0, 1.0)]
        found: Array = np.max(np.abs(off), axis=0)
        return found


def changes_of(done: Done) -> Changes:
    """The changes of a cell of curves."""
    factors = np.array(done.cell.inputs["factors"])
    apexes = np.stack([done.column("x_bar"), done.column("y_bar")], axis=-1)
    apexes = apexes.reshape(len(NAMES), len(factors), 2)
    (right,) = np.flatnonzero(np.abs(factors - 1.0) < SMALLEST)
    apex = apexes[0, right]
    return Changes(factors - 1.0, apex, apexes / apex - 1.0)


def tangents_of(done: Done) -> Array:
    """The exact elasticities (4, 2) of a cell."""
    return np.stack([done.column("x_elasticity"), done.column("y_elasticity")], axis=-1)


def largest_elsewhere(rows: Sequence[Row], key: str, error: float) -> Array:
    """Largest changes (4, N) of N designs at an error either way, for each parameter."""
    found: dict[tuple[int, int], list[float]] = {}
    for row in rows:
        if abs(abs(row["factor"] - 1.0) - error) < SMALLEST:
            place = NAMES.index(row["parameter"]), row["design"]
            value: Any = row[key]
            found.setdefault(place, []).append(np.inf if value is None else abs(value))
    count = 1 + max(design for _, design in found)
    return np.array([[max(found[k, n]) for n in range(count)] for k in range(len(NAMES))])
