"""Central differences (velocity Verlet): explicit, second order, stable up to h omega = 2.

    q_1 = q_0 + h v_0 + h^2/2 a_0
    a_1 = -M^-1 forces(q_1, v_0 + h a_0)
    v_1 = v_0 + h/2 (a_0 + a_1)

Forces that depend on the velocity see its prediction, so that a mode with stiffness k, damping c
and mass m is stable while h^2 k + 2 h c <= 4 m. The march computes that bound at every step from
the tangent stiffness, for which the stage's rate is 2/h, and holds the step to it.
"""

from typing import Any, NamedTuple

from snapjump.integrator.base import Rates, TimeIntegrator
from snapjump.number.functions import fma, sqrt


@TimeIntegrator.member
class CentralDifference(NamedTuple):
    """No numbers."""

    def slots(self) -> int:
        return 2

    def stage_count(self) -> int:
        return 1

    def is_explicit(self) -> bool:
        return True

    def ends_in_a_stage(self) -> bool:
        return True

    def stage_node(self, stage: Any) -> Any:
        return 1.0 + 0.0 * stage

    def stage_rates(self, step: Any, ratio: Any) -> Any:
        return Rates(2.0 / step, 0.0 * step)

    def weigh_slots(self, stage: Any, step: Any, ratio: Any, weights: Any) -> None:
        weights[0] = step

    def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
        h = work.weights[0]
        a = work.acceleration[0, i]
        velocity = work.velocity[0, i]
        aim = fma(h, fma(0.5 * h, a, velocity), work.start[i])
        # The assembly finds the predicted velocity as (aim - origin) rate_factor.
        return aim - 0.5 * h * fma(h, a, velocity), velocity, aim

    def store_stage(
        self, work: Any, stage: Any, step: Any, ratio: Any, rates: Any, mask: Any
    ) -> Any:
        total = 0.0 * step
        for i in range(work.state.shape[0]):
            before = work.acceleration[0, i]
            after = work.change[i]
            work.velocity[1, i] = fma(0.5 * step, before + after, work.velocity[0, i])
            work.acceleration[1, i] = after
            total = fma(after - before, after - before, total)
        return sqrt(total / work.state.shape[0]) * (step * step / 6.0)

    def end_step(self, work: Any, step: Any, mask: Any) -> None:
        pass

    def keep_history(self, work: Any, step: Any, mask: Any) -> None:
        pass

    def error_power(self) -> float:
        return 3.0

    def quadrature_weight(self, stage: Any) -> float:
        return 0.5
