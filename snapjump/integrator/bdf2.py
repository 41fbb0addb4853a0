"""BDF2 with variable steps: second order, one stage a step, L-stable at a constant step.

With w the ratio of this step to the last one, h the step, and D = (q_n - q_{n-1}) / h_{n-1},

    q_{n+1} = q_n + h w / (1 + 2 w) D + h (1 + w) / (1 + 2 w) v_{n+1},

and the same for the velocity; w = 0, which has no past, is implicit Euler. Zero-stable for
w < 1 + sqrt(2) (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, III.5).
Slot 2 keeps D of position and velocity.
"""

from typing import Any, NamedTuple

from snapjump.integrator.base import IntegratorOptions, Rates, Reached, TimeIntegrator
from snapjump.number.functions import fma, where

HISTORY = 2


class Bdf2(IntegratorOptions):
    """Second order, one stage, two steps; L-stable; steps may vary."""

    order = 2
    damping_at_infinity = 0.0

    @TimeIntegrator.member
    class Scheme(NamedTuple):
        """No numbers: the ratio of the steps says all."""

        def slots(self) -> int:
            return 3

        def stage_rates(self, step: Any, ratio: Any) -> Any:
            rate = (1.0 + 2.0 * ratio) / ((1.0 + ratio) * step)
            return Rates(rate, rate)

        def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
            coefficients[0] = step * ratio / (1.0 + 2.0 * ratio)

        def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
            position = fma(work.coefficients[0], work.velocity[HISTORY, i], work.start[i])
            velocity = fma(work.coefficients[0], work.acceleration[HISTORY, i], work.velocity[0, i])
            share = 1.0 / rates.rate_factor
            return (
                position,
                velocity,
                position + share * (velocity + share * work.acceleration[0, i]),
            )

        def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
            # The local error (1 + w)^2 / (6 w (1 + 2 w)) h^3 q''' with q''' from the second
            # difference of v_{n+1}, v_n and D, the velocity half a step ago but for a known share
            # of q'''.
            before = work.velocity[0, i]
            past = 2.0 * ratio * (before - work.velocity[HISTORY, i])
            return reached.velocity - before - past

        def error_scale(self, step: Any, ratio: Any) -> Any:
            grown = 1.0 + ratio
            return grown * grown / ((1.0 + 2.0 * ratio) * (2.0 + 3.0 * ratio)) * step

        def keep_history(self, work: Any, i: Any, step: Any, reached: Reached, mask: Any) -> None:
            over = 1.0 / step
            moved = (work.state[i] - work.start[i]) * over
            sped = (reached.velocity - work.velocity[0, i]) * over
            work.velocity[HISTORY, i] = where(mask, moved, work.velocity[HISTORY, i])
            work.acceleration[HISTORY, i] = where(mask, sped, work.acceleration[HISTORY, i])

        def error_power(self) -> float:
            return 3.0

    def scheme(self) -> Scheme:
        """The scheme for the kernels."""
        return self.Scheme()
