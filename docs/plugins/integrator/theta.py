"""The theta method: between the trapezoidal rule (1/2) and implicit Euler (1).

q_1 = q_0 + h ((1 - theta) v_0 + theta v_1),   v_1 = v_0 + h ((1 - theta) a_0 + theta a_1)
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.integrator.base import IntegratorOptions, Rates, Reached, TimeIntegrator
from snapjump.number.functions import fma


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

        def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
            slow = (self.theta - 0.5) * (reached.velocity - work.velocity[0, i])
            return fma(step / 12.0, reached.acceleration - work.acceleration[0, i], slow)

        def error_scale(self, step: Any, ratio: Any) -> Any:
            return step

        def error_power(self) -> float:
            return 2.0

    def scheme(self) -> Scheme:
        """The scheme for the kernels."""
        return self.Scheme(self.theta)
