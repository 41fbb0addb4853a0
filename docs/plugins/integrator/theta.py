"""The theta method: between the trapezoidal rule (1/2) and implicit Euler (1).

q_1 = q_0 + h ((1 - theta) v_0 + theta v_1),   v_1 = v_0 + h ((1 - theta) a_0 + theta a_1)
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.integrator.base import IntegratorOptions, Rates, TimeIntegrator
from snapjump.number.functions import fma, sqrt


class Theta(IntegratorOptions):
    """The theta method: of first order but for 1/2; damps fast modes as much as is wanted."""

    theta: float = number(0.55, least=0.5, most=1.0)

    @property
    def order(self) -> int:
        return 2 if self.theta == 0.5 else 1

    @property
    def damping_at_infinity(self) -> float:
        return (1.0 - self.theta) / self.theta

    @TimeIntegrator.member
    class Scheme(NamedTuple):
        """theta."""

        theta: float

        def slots(self) -> int:
            return 2

        def stage_rates(self, step: Any, ratio: Any) -> Any:
            rate = 1.0 / (self.theta * step)
            return Rates(rate, rate)

        def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
            coefficients[0] = (1.0 - self.theta) * step

        def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
            position = fma(work.coefficients[0], work.velocity[0, i], work.start[i])
            velocity = fma(work.coefficients[0], work.acceleration[0, i], work.velocity[0, i])
            share = 1.0 / rates.rate_factor
            guess = velocity + share * work.acceleration[0, i]
            return position, velocity, position + share * guess

        def store_stage(
            self, work: Any, stage: Any, step: Any, ratio: Any, rates: Any, mask: Any
        ) -> Any:
            rate, total = rates.rate_factor, 0.0 * step
            for i in range(work.state.shape[0]):
                v = (work.state[i] - work.position_predictor[i]) * rate
                a = (v - work.velocity_predictor[i]) * rate
                slow = (self.theta - 0.5) * (v - work.velocity[0, i])
                error = fma(step / 12.0, a - work.acceleration[0, i], slow)
                work.velocity[1, i] = v
                work.acceleration[1, i] = a
                total = fma(error, error, total)
            return sqrt(total / work.state.shape[0]) * step

        def error_power(self) -> float:
            return 2.0

    def scheme(self) -> Scheme:
        """The scheme for the kernels."""
        return self.Scheme(self.theta)
