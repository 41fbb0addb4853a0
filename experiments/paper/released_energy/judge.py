"""Verdicts on the released energy, and on the released program's depths."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from experiments.paper import exact
from experiments.paper.settings import RANGES
from experiments.paper.statement import Statement, verdict
from snapjump.run.studies.base import Row

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


COMMAND = "task=paper figure=released_energy"
# Largest deviation from a straight line, of the value: below the first it cannot be seen in a
# figure of the whole range, below the second the line still serves for estimates.
STRAIGHT_PERCENT, NEARLY_PERCENT = 1.0, 5.0
# The program adds 1 % to its h1, which is the error that it allows its polynomials; they hold on
# its own mesh if they are within twice that there, its own fit to single runs included.
FIT_PERCENT, OWN_MESH_PERCENT = 1.0, 2.0


def energy_statement(alike: Sequence[Row], own_mesh: Sequence[Row], accuracy: str) -> Statement:
    """Whether the released energy of clamps that turn alike is linear in epsilon."""
    paper, whole = straight_line(within(alike)), straight_line(alike)
    ratio = growth(alike)
    first = alike[0]["epsilon"]
    return Statement(
        "The energy that the snap releases grows linearly with ε",
        verdict(
            paper.deviation_percent < STRAIGHT_PERCENT,
            paper.deviation_percent < NEARLY_PERCENT,
        ),
        f"over the paper's range the best line, {told(paper.slope, paper.intercept)} in EI/L, is "
        f"off by up to {paper.deviation_percent:.2g} % of the value (at "
        f"ε = {paper.worst_epsilon:g}; on the paper's mesh "
        f"{straight_line(own_mesh).deviation_percent:.2g} %); down to ε = {first:g}, with "
        f"{told(whole.slope, whole.intercept)}, by up to {whole.deviation_percent:.2g} % (at "
        f"ε = {whole.worst_epsilon:g}). A shallow arch releases {shallow_slope():.3g} ε exactly in "
        f"proportion; what is released differs from that by {ratio[place(alike, LOW)]:+.2g} % at "
        f"ε = {LOW:g} and by {ratio[-1]:+.2g} % at ε = {HIGH:g}",
        accuracy,
        COMMAND,
    )


def shallow_slope() -> float:
    """Released energy over epsilon (EI/L) in the limit of shallow arches."""
    return exact.shallow()["E_over_eps_released"]


def growth(rows: Sequence[Row]) -> np.ndarray:
    """How much more is released than in proportion to a shallow arch (%)."""
    energy, epsilon = column(rows, "energy_released_bar"), column(rows, "epsilon")
    return np.asarray(100.0 * (energy / (shallow_slope() * epsilon) - 1.0))


def place(rows: Sequence[Row], epsilon: float) -> int:
    """The index of the row nearest to a pre-compression."""
    return int(np.argmin(np.abs(column(rows, "epsilon") - epsilon)))


def told(slope: float, intercept: float) -> str:
    """A line in words."""
    sign = "-" if intercept < 0.0 else "+"
    return f"{slope:.3g} ε {sign} {abs(intercept):.2g}"


def heights_statement(
    alike: Sequence[Row], own_mesh: Sequence[Row], lagging: Sequence[Row], accuracy: str
) -> Statement:
    """Whether the released program's polynomials are what an arch does.

    ``alike``: converged; ``own_mesh``: with the program's clamps; ``lagging``: these with a small
    mismatch.
    """
    paper = within(alike)
    converged, own, tilted = (
        {name: fit_errors(rows, name) for name in HEIGHTS} for rows in (paper, own_mesh, lagging)
    )
    factor = exact.released_factor()
    gaps = factor * exact.released_height("h1", column(paper, "epsilon")) - column(paper, "h1_bar")
    return Statement(
        "(released program) Its polynomials give the depth h1(ε) of the critical arch's lowest "
        "point and the depth h2(ε) of the snapped arch's middle",
        verdict(largest(converged) < FIT_PERCENT, largest(own) < OWN_MESH_PERCENT),
        f"against the converged arch h1 is off by {span(converged['h1'])} % (with the factor of "
        f"{factor:g} that the program adds, the clamps stand up to {gaps.max():.2g} L too high) "
        f"and h2 by {span(converged['h2'])} %. On the program's own mesh, whose clamps are two "
        f"fixed nodes, h1 is off by {span(own['h1'])} % and h2 by {span(own['h2'])} % (the best "
        f"quadratic through h2 by {left_by_quadratics(own_mesh, 'h2'):.2g} %); there, with a "
        f"mismatch of {lagging[0]['delta_alpha_rad']:g} rad, h1 by {span(tilted['h1'])} % and h2 "
        f"by {span(tilted['h2'])} %. The cause of what h2 is off by is open",
        accuracy,
        COMMAND,
    )


def span(values: np.ndarray) -> str:
    """From the least to the largest, with signs."""
    return f"{values.min():+.2g} to {values.max():+.2g}"


def largest(errors: Mapping[str, np.ndarray]) -> float:
    """Size of the largest of all."""
    return max(float(np.abs(one).max()) for one in errors.values())


def accuracy_of(rows: Sequence[Row], reference: Sequence[Row], keys: Sequence[str]) -> str:
    """The tiers, and how far they are from the exact elastica over the paper's range."""
    return (
        f"`standard` ({largest_difference(within(rows), keys):.2g} %), "
        f"`reference` ({largest_difference(reference, keys):.2g} %)"
    )
