"""BDF2 with variable steps: second order, one stage a step, L-stable at a constant step.

With w the ratio of this step to the last one, h the step, and D = (q_n - q_{n-1}) / h_{n-1},

    q_{n+1} = q_n + h w / (1 + 2 w) D + h (1 + w) / (1 + 2 w) v_{n+1},

and the same for the velocity; w = 0, which has no past, is implicit Euler. Zero-stable for
w < 1 + sqrt(2) (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, III.5).
Slot 2 keeps D of position and velocity.
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
from snapjump.number.functions import fma, sqrt, where

HISTORY = 2


class Bdf2(NamedTuple):
    """No numbers: the ratio of the steps says all."""


@slots.member(Bdf2)
def _slots(scheme: Bdf2) -> int:
    return 3


@stage_count.member(Bdf2)
def _stage_count(scheme: Bdf2) -> int:
    return 1


@is_explicit.member(Bdf2)
def _is_explicit(scheme: Bdf2) -> bool:
    return False


@ends_in_a_stage.member(Bdf2)
def _ends_in_a_stage(scheme: Bdf2) -> bool:
    return True


@stage_node.member(Bdf2)
def _stage_node(scheme: Bdf2, stage: Any) -> Any:
    return 1.0 + 0.0 * stage


@stage_rates.member(Bdf2)
def _stage_rates(scheme: Bdf2, step: Any, ratio: Any) -> Any:
    rate = (1.0 + 2.0 * ratio) / ((1.0 + ratio) * step)
    return Rates(rate, rate)


@weigh_slots.member(Bdf2)
def _weigh_slots(scheme: Bdf2, stage: Any, step: Any, ratio: Any, weights: Any) -> None:
    weights[0] = step * ratio / (1.0 + 2.0 * ratio)


@predict.member(Bdf2)
def _predict(scheme: Bdf2, work: Any, i: Any, stage: Any, rates: Any) -> Any:
    origin = fma(work.weights[0], work.velocity[HISTORY, i], work.start[i])
    drift = fma(work.weights[0], work.acceleration[HISTORY, i], work.velocity[0, i])
    share = 1.0 / rates.rate_factor
    return origin, drift, origin + share * (drift + share * work.acceleration[0, i])


@store_stage.member(Bdf2)
def _store_stage(
    scheme: Bdf2, work: Any, stage: Any, step: Any, ratio: Any, rates: Any, mask: Any
) -> Any:
    # The local error (1 + w)^2 / (6 w (1 + 2 w)) h^3 q''' with q''' from the second difference
    # of v_{n+1}, v_n and D, which is the velocity half a step ago but for a known share of q'''.
    rate = rates.rate_factor
    grown = 1.0 + ratio
    scale = grown * grown / ((1.0 + 2.0 * ratio) * (2.0 + 3.0 * ratio))
    total = 0.0 * rate
    for i in range(work.state.shape[0]):
        v = (work.state[i] - work.origin[i]) * rate
        begun = work.velocity[0, i]
        work.velocity[1, i] = v
        work.acceleration[1, i] = (v - work.drift[i]) * rate
        past = 2.0 * ratio * (begun - work.velocity[HISTORY, i])
        error = v - begun - past
        total = fma(error, error, total)
    return sqrt(total / work.state.shape[0]) * (scale * step)


@end_step.member(Bdf2)
def _end_step(scheme: Bdf2, work: Any, step: Any, mask: Any) -> None:
    pass


@keep_history.member(Bdf2)
def _keep_history(scheme: Bdf2, work: Any, step: Any, mask: Any) -> None:
    over = 1.0 / step
    for i in range(work.state.shape[0]):
        moved = (work.state[i] - work.start[i]) * over
        sped = (work.velocity[1, i] - work.velocity[0, i]) * over
        work.velocity[HISTORY, i] = where(mask, moved, work.velocity[HISTORY, i])
        work.acceleration[HISTORY, i] = where(mask, sped, work.acceleration[HISTORY, i])


@error_order.member(Bdf2)
def _error_order(scheme: Bdf2) -> float:
    return 3.0


@quadrature_weight.member(Bdf2)
def _quadrature_weight(scheme: Bdf2, stage: Any) -> float:
    return 0.5
