"""Straight lines through the released energy, and the released program's fits of the depths."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from experiments.paper import exact
from experiments.paper.baseline import RANGES
from snapjump.studies.base import Row

Array = NDArray[np.float64]
LOW, HIGH = RANGES["epsilon"]  # the paper's
HEIGHTS = ("h1", "h2")


@dataclass(frozen=True)
class Line:
    """intercept + slope * epsilon (EI/L), by least squares, and where it is off most."""

    slope: float
    intercept: float
    deviation_percent: float  # the largest, of the value there
    worst_epsilon: float

    def at(self, epsilon: Array) -> Array:
        """The line's values."""
        return self.intercept + self.slope * epsilon


def column(rows: Sequence[Row], key: str) -> Array:
    """Numbers of rows."""
    return np.array([row[key] for row in rows], float)


def within(rows: Sequence[Row], low: float = LOW, high: float = HIGH) -> list[Row]:
    """The rows of a range of epsilon, ends included."""
    return [row for row in rows if low - 1e-9 <= row["epsilon"] <= high + 1e-9]


def straight_line(rows: Sequence[Row]) -> Line:
    """Through the released energy of these rows."""
    epsilon, energy = column(rows, "epsilon"), column(rows, "energy_released_bar")
    slope, intercept = np.polyfit(epsilon, energy, 1)
    off = 100.0 * np.abs((intercept + slope * epsilon) / energy - 1.0)
    worst = int(np.argmax(off))
    return Line(float(slope), float(intercept), float(off[worst]), float(epsilon[worst]))


def fit_errors(rows: Sequence[Row], name: str) -> Array:
    """The released program's polynomial against a depth of ours, of every row (%)."""
    fit = exact.released_height(name, column(rows, "epsilon"))
    return np.asarray(100.0 * (fit / column(rows, f"{name}_bar") - 1.0))


def left_by_quadratics(rows: Sequence[Row], name: str) -> float:
    """What the best quadratic through a depth of these rows is off by at most (%)."""
    epsilon, depth = column(rows, "epsilon"), column(rows, f"{name}_bar")
    best = np.polyval(np.polyfit(epsilon, depth, 2), epsilon)
    return float(np.max(100.0 * np.abs(best / depth - 1.0)))


def exact_value(epsilon: float, delta_alpha: float, key: str) -> float | None:
    """The exact number beside a row of an arch; None where there is none.

    ``key``: as in the rows; h1 is known of clamps that turn alike.
    """
    if delta_alpha == 0.0:
        entry = exact.symmetric(epsilon)
        numbers = {
            "energy_released_bar": entry["dE_asym"],
            "h1_bar": -entry["ymin_before_asym"],
            "h2_bar": -entry["ymid_after_asym"],
        }
        return numbers.get(key)
    lagging = exact.mismatched(epsilon, delta_alpha, stretches=False)
    numbers = {
        "energy_released_bar": lagging["before_E"] - lagging["after_E"],
        "h2_bar": -lagging["after_ymid"],
    }
    return numbers.get(key)


def largest_difference(rows: Sequence[Row], keys: Sequence[str]) -> float:
    """Of ours from the exact numbers (%), wherever there is one."""
    found = [0.0]
    for row in rows:
        alike = row["delta_alpha_rad"] == 0.0
        if row["epsilon"] not in (exact.SYMMETRIC if alike else exact.COMPARED):
            continue
        for key in keys:
            value = exact_value(row["epsilon"], row["delta_alpha_rad"], key)
            if value is not None:
                found.append(100.0 * abs(row[key] / value - 1.0))
    return max(found)
