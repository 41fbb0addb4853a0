"""Runge-Kutta methods whose end is not a stage: the stages' velocities are added up once more.

Contact guards the stages only, so that the end of every step is checked by itself.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.integrator.base import Reached
from snapjump.integrator.parts.dirk import DirkScheme
from snapjump.number.functions import fma, where


@DirkScheme.member
class QuadratureTableau(NamedTuple):
    """A :class:`~snapjump.integrator.parts.dirk.Tableau` whose stage 0 has no weight.

    ``comparison`` weighs accelerations times the step, that of stage 0 being the last one before.
    """

    gamma: float
    matrix: NDArray[np.float64]
    nodes: NDArray[np.float64]
    weights: NDArray[np.float64]
    comparison: tuple[float, ...]
    error_order: float

    def ends_in_a_stage(self) -> bool:
        return False

    def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
        last = len(self.comparison) - 1
        total = 0.0 * step
        for k in range(last):
            total = fma(step * self.comparison[k], work.acceleration[k, i], total)
        return fma(step * self.comparison[last], reached.acceleration, total)

    def end_step(self, work: Any, step: Any, mask: Any) -> None:
        last = len(self.comparison) - 1
        for i in range(work.state.shape[0]):
            position = work.start[i]
            velocity = work.velocity[0, i]
            for k in range(1, last + 1):
                weight = step * self.weights[k]
                position = position + weight * work.velocity[k, i]
                velocity = velocity + weight * work.acceleration[k, i]
            work.state[i] = where(mask, position, work.state[i])
            work.velocity[last, i] = where(mask, velocity, work.velocity[last, i])
