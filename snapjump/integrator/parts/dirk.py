"""Diagonally implicit Runge-Kutta methods, given by a Butcher tableau.

Stage 0 is the (explicit) beginning of the step; stages 1 ... S are implicit with one diagonal
coefficient gamma. They end in their last stage (stiffly accurate): whatever a stage guards, the
end of the step guards too. For others see :mod:`snapjump.integrator.parts.quadrature_dirk`.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.integrator.base import Rates, TimeIntegrator
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true, fma, sqrt, where


@kernel
def pick(table: Any, stage: Any) -> Any:
    """The table's entry at every lane's own stage."""
    value = 0.0 * stage
    for k in range(table.shape[0]):
        value = where(stage == 1.0 * k, table[k] + value, value)
    return value


@kernel
def step_error(tableau: Any, work: Any, i: Any, step: Any) -> Any:
    """Difference of the step from the comparison method, in position over the step (L/T)."""
    total = 0.0 * step
    if tableau.ends_in_a_stage():
        for k in range(len(tableau.error)):
            total = fma(tableau.error[k], work.velocity[k, i], total)
    else:
        for k in range(len(tableau.error)):
            total = fma(step * tableau.error[k], work.acceleration[k, i], total)
    return total


class DirkScheme(TimeIntegrator):
    """Diagonally implicit Runge-Kutta schemes, but for how their steps end."""

    gamma: Any
    matrix: Any
    nodes: Any
    weights: Any
    error: Any
    error_order: Any

    def slots(self) -> Any:
        return len(self.error)

    def stage_count(self) -> Any:
        return len(self.error) - 1

    def abscissa(self, stage: Any) -> Any:
        return pick(self.nodes, stage)

    def stage_rates(self, step: Any, ratio: Any) -> Any:
        rate = 1.0 / (self.gamma * step)
        return Rates(rate, rate)

    def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
        for k in range(len(self.error) - 1):
            coefficients[k] = step * pick(self.matrix[:, k], stage)

    def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
        position = work.start[i]
        velocity = work.velocity[0, i]
        guess = work.acceleration[0, i]
        for k in range(len(self.error) - 1):
            earlier = work.acceleration[k, i]
            position = fma(work.coefficients[k], work.velocity[k, i], position)
            velocity = fma(work.coefficients[k], earlier, velocity)
            guess = where(stage > 1.0 * k, earlier, guess)
        share = 1.0 / rates.rate_factor
        return position, velocity, position + share * (velocity + share * guess)

    def store_stage(
        self, work: Any, stage: Any, step: Any, ratio: Any, rates: Any, mask: Any
    ) -> Any:
        last = len(self.error) - 1
        rate = rates.rate_factor
        for k in range(1, last):
            here = mask & (stage == 1.0 * k)
            if any_true(here):
                velocity = work.velocity[k]
                acceleration = work.acceleration[k]
                for i in range(work.state.shape[0]):
                    v = (work.state[i] - work.position_predictor[i]) * rate
                    a = (v - work.velocity_predictor[i]) * rate
                    velocity[i] = where(here, v, velocity[i])
                    acceleration[i] = where(here, a, acceleration[i])
        total = 0.0 * rate
        if any_true(mask & (stage >= 1.0 * last)):
            # The last stage is used up at once: other lanes' entries may be overwritten.
            velocity = work.velocity[last]
            acceleration = work.acceleration[last]
            for i in range(work.state.shape[0]):
                v = (work.state[i] - work.position_predictor[i]) * rate
                velocity[i] = v
                acceleration[i] = (v - work.velocity_predictor[i]) * rate
                error = step_error(self, work, i, step)
                total = fma(error, error, total)
        return sqrt(total / work.state.shape[0]) * step

    def error_power(self) -> Any:
        return self.error_order

    def quadrature_weight(self, stage: Any) -> Any:
        return self.weights[stage]


@DirkScheme.member
class Tableau(NamedTuple):
    """A Butcher tableau whose last stage is the end of the step.

    gamma: diagonal coefficient; matrix (S + 1, S + 1) strictly lower part by which earlier stages
    enter; nodes (S + 1); weights (S + 1); error (S + 1): weights minus those of a comparison
    method, a tuple, so that kernels know the number of stages while they are compiled.
    """

    gamma: float
    matrix: NDArray[np.float64]
    nodes: NDArray[np.float64]
    weights: NDArray[np.float64]
    error: tuple[float, ...]
    error_order: float
