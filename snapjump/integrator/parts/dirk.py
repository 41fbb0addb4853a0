"""Diagonally implicit Runge-Kutta methods, given by a Butcher tableau.

Stage 0 is the (explicit) beginning of the step; stages 1 ... S are implicit with one diagonal
coefficient gamma. They end in their last stage (stiffly accurate): whatever a stage guards, the
end of the step guards too. For others see :mod:`snapjump.integrator.parts.quadrature_dirk`.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.integrator.base import Rates, Reached, TimeIntegrator
from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma, where


@kernel
def pick(table: Any, stage: Any) -> Any:
    """The table's entry at every lane's own stage."""
    value = 0.0 * stage
    for k in range(table.shape[0]):
        value = where(stage == 1.0 * k, table[k] + value, value)
    return value


class DirkScheme(TimeIntegrator):
    """Diagonally implicit Runge-Kutta schemes, but for how their steps end."""

    gamma: Any
    matrix: Any
    nodes: Any
    weights: Any
    comparison: Any
    error_order: Any

    def slots(self) -> Any:
        return len(self.comparison)

    def stage_count(self) -> Any:
        return len(self.comparison) - 1

    def abscissa(self, stage: Any) -> Any:
        return pick(self.nodes, stage)

    def stage_rates(self, step: Any, ratio: Any) -> Any:
        rate = 1.0 / (self.gamma * step)
        return Rates(rate, rate)

    def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
        for k in range(len(self.comparison) - 1):
            coefficients[k] = step * pick(self.matrix[:, k], stage)

    def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
        position = work.start[i]
        velocity = work.velocity[0, i]
        guess = work.acceleration[0, i]
        for k in range(len(self.comparison) - 1):
            earlier = work.acceleration[k, i]
            position = fma(work.coefficients[k], work.velocity[k, i], position)
            velocity = fma(work.coefficients[k], earlier, velocity)
            guess = where(stage > 1.0 * k, earlier, guess)
        share = 1.0 / rates.rate_factor
        return position, velocity, position + share * (velocity + share * guess)

    def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
        last = len(self.comparison) - 1
        total = 0.0 * step
        for k in range(last):
            total = fma(self.comparison[k], work.velocity[k, i], total)
        return fma(self.comparison[last], reached.velocity, total)

    def error_scale(self, step: Any, ratio: Any) -> Any:
        return step

    def error_power(self) -> Any:
        return self.error_order

    def quadrature_weight(self, stage: Any) -> Any:
        return self.weights[stage]


@DirkScheme.member
class Tableau(NamedTuple):
    """A Butcher tableau whose last stage is the end of the step.

    gamma: diagonal coefficient; matrix (S + 1, S + 1) strictly lower part by which earlier stages
    enter; nodes (S + 1); weights (S + 1); comparison (S + 1): weights minus those of a comparison
    method, a tuple, so that kernels know the number of stages while they are compiled.
    """

    gamma: float
    matrix: NDArray[np.float64]
    nodes: NDArray[np.float64]
    weights: NDArray[np.float64]
    comparison: tuple[float, ...]
    error_order: float
