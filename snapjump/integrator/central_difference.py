"""Central differences (velocity Verlet): explicit, second order, stable up to h omega = 2.

    q_1 = q_0 + h v_0 + h^2/2 a_0
    a_1 = -M^-1 forces(q_1, v_0 + h a_0)
    v_1 = v_0 + h/2 (a_0 + a_1)

Forces that depend on the velocity see its prediction, so that a mode with stiffness k, damping c
and mass m is stable while h^2 k + 2 h c <= 4 m. The march computes that bound at every step from
the tangent stiffness, for which the stage's rate is 2/h, and holds the step to it.
"""

from typing import Any, NamedTuple

from snapjump.integrator.base import (
    Rates,
    end_step,
    ends_in_a_stage,
    error_order,
    is_explicit,
    keep_history,
    predict,
    quadrature_weight,
    slots,
    stage_count,
    stage_node,
    stage_rates,
    store_stage,
    weigh_slots,
)
from snapjump.number.functions import fma, sqrt


class CentralDifference(NamedTuple):
    """No numbers."""


@slots.member(CentralDifference)
def _slots(scheme: CentralDifference) -> int:
    return 2


@stage_count.member(CentralDifference)
def _stage_count(scheme: CentralDifference) -> int:
    return 1


@is_explicit.member(CentralDifference)
def _is_explicit(scheme: CentralDifference) -> bool:
    return True


@ends_in_a_stage.member(CentralDifference)
def _ends_in_a_stage(scheme: CentralDifference) -> bool:
    return True


@stage_node.member(CentralDifference)
def _stage_node(scheme: CentralDifference, stage: Any) -> Any:
    return 1.0 + 0.0 * stage


@stage_rates.member(CentralDifference)
def _stage_rates(scheme: CentralDifference, step: Any, ratio: Any) -> Any:
    return Rates(2.0 / step, 0.0 * step)


@weigh_slots.member(CentralDifference)
def _weigh_slots(
    scheme: CentralDifference, stage: Any, step: Any, ratio: Any, weights: Any
) -> None:
    weights[0] = step


@predict.member(CentralDifference)
def _predict(scheme: CentralDifference, work: Any, i: Any, stage: Any, rates: Any) -> Any:
    h = work.weights[0]
    a = work.acceleration[0, i]
    velocity = work.velocity[0, i]
    aim = fma(h, fma(0.5 * h, a, velocity), work.start[i])
    # The assembly finds the predicted velocity as (aim - origin) rate_factor.
    return aim - 0.5 * h * fma(h, a, velocity), velocity, aim


@store_stage.member(CentralDifference)
def _store_stage(
    scheme: CentralDifference, work: Any, stage: Any, step: Any, ratio: Any, rates: Any, mask: Any
) -> Any:
    total = 0.0 * step
    for i in range(work.state.shape[0]):
        before = work.acceleration[0, i]
        after = work.change[i]
        work.velocity[1, i] = fma(0.5 * step, before + after, work.velocity[0, i])
        work.acceleration[1, i] = after
        total = fma(after - before, after - before, total)
    return sqrt(total / work.state.shape[0]) * (step * step / 6.0)


@end_step.member(CentralDifference)
def _end_step(scheme: CentralDifference, work: Any, step: Any, mask: Any) -> None:
    pass


@keep_history.member(CentralDifference)
def _keep_history(scheme: CentralDifference, work: Any, step: Any, mask: Any) -> None:
    pass


@error_order.member(CentralDifference)
def _error_order(scheme: CentralDifference) -> float:
    return 3.0


@quadrature_weight.member(CentralDifference)
def _quadrature_weight(scheme: CentralDifference, stage: Any) -> float:
    return 0.5
