"""Targets within the achievable regions of their robots."""

from typing import Any, NamedTuple

from experiments.paper.baseline import BASELINE

MASS_BAR, MU = BASELINE[2:]


class Case(NamedTuple):
    """A robot on a ground, and where it is to jump: the apex x, y in L."""

    label: str
    mass_bar: float
    mu: float
    x_bar: float
    y_bar: float


ONE_ROBOT = tuple(
    Case(f"{row}{column}", MASS_BAR, MU, x, y)
    for row, y in zip("ABC", (20.0, 16.0, 12.0), strict=True)
    for column, x in zip("123", (2.0, 3.5, 5.0), strict=True)
)
# The fourth and the fifth share their target.
MANY_ROBOTS = (
    Case("R1", 0.35, 0.5, 10.0, 40.0),
    Case("R2", 0.4, 0.3, 4.0, 45.0),
    Case("R3", 0.5, 0.3, 7.0, 30.0),
    Case("R4", 0.5, 0.15, 3.0, 22.0),
    Case("R5", 0.768, 0.45, 3.0, 22.0),
    Case("R6", 0.9, 0.6, 7.0, 14.0),
    Case("R7", 1.2, 0.2, 2.0, 13.0),
    Case("R8", 2.0, 0.3, 1.5, 8.0),
)
GROUPS: dict[str, tuple[Case, ...]] = {"one robot": ONE_ROBOT, "many robots": MANY_ROBOTS}
METHODS = ("adam", "gauss_newton", "physics")


def case_of(row: Any) -> Case:
    """A case from plain values in its order."""
    return Case(str(row[0]), *(float(value) for value in row[1:]))
