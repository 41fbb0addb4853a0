"""Options of Runge-Kutta methods: each is a YAML file in ``snapjump/integrator``."""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np

from snapjump.checks import ParameterError, check_number
from snapjump.declare.fields import construct, hidden, integer, number
from snapjump.integrator.base import IntegratorOptions
from snapjump.integrator.parts.dirk import Tableau
from snapjump.integrator.parts.quadrature_dirk import QuadratureTableau

Rows = tuple[tuple[float, ...], ...]
ACCELERATION_ERROR = 1.0 / 12.0  # of h^2 (a_1 - a_0), the error of the trapezoidal rule
ROUNDING = 1e-12
SMALLEST_DISTANCE = 1e-6  # of nodes that carry a quadrature


class RungeKutta(IntegratorOptions):
    """A diagonally implicit Runge-Kutta method.

    ``method`` is its name, that of its file.
    ``rows`` of its matrix up to the diagonal, stage 0 (the step's beginning) first; ``weights`` of
    the end, None if that is the last stage; ``embedded`` weights of a comparison method, None for
    the quadrature of highest order on the nodes. ``order`` and ``damping_at_infinity`` (the
    amplification of an infinitely fast oscillation) are what a test measures.
    """

    order: int = integer(least=1, most=12)  # type: ignore[misc]
    damping_at_infinity: float = number(least=0.0, most=1.0)  # type: ignore[misc]
    rows: Rows  # type: ignore[misc]
    weights: tuple[float, ...] | None = None
    embedded: tuple[float, ...] | None = None
    method: str = hidden("runge_kutta")

    @property
    def name(self) -> str:
        return self.method

    def __post_init__(self) -> None:
        super().__post_init__()
        rows = checked_rows(self.rows)
        object.__setattr__(self, "rows", rows)
        for key in ("weights", "embedded"):
            given = getattr(self, key)
            if given is not None:
                row = checked_row(f"integrator.{key}", given, len(rows))
                object.__setattr__(self, key, row)
                if abs(sum(row) - 1.0) > ROUNDING:
                    raise ParameterError(f"integrator.{key}", list(given), "weights that add to 1")
        if self.weights is not None and any((self.weights[0], *(row[0] for row in rows))):
            raise ParameterError(
                "integrator.weights", list(self.weights), "null where stage 0 enters any stage"
            )
        self._check_nodes()

    def _check_nodes(self) -> None:
        """A last stage that ends the step, and nodes that a quadrature can be built on."""
        if self.weights is not None:
            return
        nodes = [sum(row) for row in self.rows]
        if abs(nodes[-1] - 1.0) > ROUNDING:
            raise ParameterError(
                "integrator.rows", list(self.rows[-1]), "a last row that adds to 1, or weights"
            )
        apart = min(b - a for a, b in pairwise(sorted(nodes)))
        if self.embedded is None and apart < SMALLEST_DISTANCE:
            raise ParameterError("integrator.embedded", None, "weights, where stages share a time")

    @property
    def stages(self) -> int:
        """Implicit stages of a step."""
        return len(self.rows) - 1

    @property
    def velocities_at_step_ends(self) -> bool:
        return self.rows == ((0.0,), (0.0, 1.0)) and self.weights is None

    def scheme(self) -> Tableau | QuadratureTableau:
        """The tableau for the kernels."""
        matrix = np.zeros((len(self.rows), len(self.rows)))
        for i, row in enumerate(self.rows):
            matrix[i, : len(row)] = row
        nodes = matrix.sum(axis=1)
        gamma = float(matrix[1, 1])
        lower = np.tril(matrix, -1)
        if self.weights is not None:
            error = np.zeros(len(nodes))
            error[0], error[-1] = -ACCELERATION_ERROR, ACCELERATION_ERROR
            weights = np.array(self.weights)
            return QuadratureTableau(gamma, lower, nodes, weights, tuple(error.tolist()), 3.0)
        order = float(self.order)
        if self.embedded is not None:
            comparison = np.array(self.embedded)
        else:
            comparison = np.array(quadrature_weights(nodes))
            order += 1.0
        error = matrix[-1] - comparison
        return Tableau(gamma, lower, nodes, matrix[-1].copy(), tuple(error.tolist()), order)


def quadrature_weights(nodes: Iterable[float]) -> list[float]:
    """Weights of the quadrature over a step that is exact for polynomials through the nodes.

    Integrals of Lagrange's polynomials, in fractions: rounded once, on every processor alike.
    """
    places = [Fraction(float(node)) for node in nodes]
    weights = []
    for k, here in enumerate(places):
        polynomial = [Fraction(1)]  # its coefficients, of 1, t, t^2, ...
        for other in places[:k] + places[k + 1 :]:
            raised = [Fraction(0), *polynomial]
            lowered = [*(other * c for c in polynomial), Fraction(0)]
            polynomial = [(a - b) / (here - other) for a, b in zip(raised, lowered, strict=True)]
        weights.append(float(sum(c / (n + 1) for n, c in enumerate(polynomial))))
    return weights


def checked_row(key: str, row: Any, length: int) -> tuple[float, ...]:
    """A row of so many numbers. Raises ParameterError."""
    if isinstance(row, str) or not hasattr(row, "__len__") or len(row) != length:
        raise ParameterError(key, row, f"a list of {length} numbers")
    for value in row:
        check_number(key, value, -1e6, 1e6)
    return tuple(float(value) for value in row)


def checked_rows(rows: Any) -> Rows:
    """The matrix of a tableau with one implicit diagonal. Raises ParameterError."""
    key = "integrator.rows"
    if isinstance(rows, str) or not hasattr(rows, "__len__") or len(rows) < 2:
        raise ParameterError(key, rows, "a list of at least two rows")
    checked = tuple(checked_row(key, row, k + 1) for k, row in enumerate(rows))
    if checked[0] != (0.0,):
        raise ParameterError(key, list(checked[0]), "[0.0] as its first row, the step's beginning")
    diagonal = {row[-1] for row in checked[1:]}
    if len(diagonal) > 1 or min(diagonal) <= 0.0:
        raise ParameterError(key, sorted(diagonal), "one positive number on the diagonal")
    return checked


def of_numbers(name: str, values: Mapping[str, Any]) -> IntegratorOptions:
    """A member that is a file of numbers alone: a Runge-Kutta method by its tableau."""
    method: IntegratorOptions = construct("integrator", RungeKutta, values).changed(method=name)
    return method
