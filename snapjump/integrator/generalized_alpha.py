"""Newmark's method and generalized-alpha (Chung and Hulbert 1993), forces weighted at step ends.

    q_1 = q_0 + h v_0 + h^2 ((1/2 - beta) a_0 + beta a_1)
    v_1 = v_0 + h ((1 - gamma) a_0 + gamma a_1)
    (1 - alpha_m) a_1 + alpha_m a_0 = (1 - alpha_f) s_1 + alpha_f s_0,   M s + forces(q, v) = 0

Weighting the forces of both ends of a step, and not evaluating them between, means that contact
guards the end of the step. Newmark's method is alpha_m = alpha_f = 0. Slot 1 holds v_1 and a_1,
slot 2 the forces s_0 among the accelerations.
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.integrator.base import IntegratorOptions, Rates, Reached, TimeIntegrator
from snapjump.number.functions import absolute, fma, maximum, where

FORCES = 2

# The estimate |beta - 1/6| h^2 (a_1 - a_0) of Zienkiewicz and Xie (1991) vanishes for linear
# acceleration, whose error is of the next order: it is held to that of the trapezoidal rule.
SMALLEST_ERROR_FACTOR = 1.0 / 12.0


class GeneralizedAlpha(IntegratorOptions):
    """Generalized-alpha (Chung and Hulbert): second order, damps fast modes as much as is wanted.

    ``spectral_radius``: amplification of an infinitely fast oscillation.
    """

    order = 2

    spectral_radius: float = number(0.5, least=0.0, most=1.0)

    @TimeIntegrator.member
    class Scheme(NamedTuple):
        """The method's four parameters."""

        beta: float
        gamma: float
        alpha_m: float
        alpha_f: float

        def slots(self) -> int:
            return 3

        def stage_rates(self, step: Any, ratio: Any) -> Any:
            share = (1.0 - self.alpha_m) / (1.0 - self.alpha_f)
            return Rates(self.gamma / (self.beta * step), share / (self.gamma * step))

        def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
            coefficients[0] = step

        def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
            h = work.coefficients[0]
            a = work.acceleration[0, i]
            forces = work.acceleration[FORCES, i]
            velocity = work.velocity[0, i]
            coasting = fma(h, velocity, work.start[i])
            known = fma(h * (1.0 - self.gamma), a, velocity)
            position = coasting + h * (h * (0.5 - self.beta) * a - self.beta / self.gamma * known)
            carried = self.alpha_m * a - self.alpha_f * forces
            velocity_predictor = known - h * self.gamma / (1.0 - self.alpha_m) * carried
            return position, velocity_predictor, fma(0.5 * h * h, a, coasting)

        def reached(self, work: Any, i: Any, step: Any, rates: Any) -> Reached:
            before = work.acceleration[0, i]
            known = fma(step * (1.0 - self.gamma), before, work.velocity[0, i])
            velocity = (work.state[i] - work.position_predictor[i]) * rates.rate_factor
            return Reached(velocity, (velocity - known) * (1.0 / (self.gamma * step)))

        def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
            return reached.acceleration - work.acceleration[0, i]

        def error_scale(self, step: Any, ratio: Any) -> Any:
            factor = maximum(absolute(self.beta - 1.0 / 6.0), SMALLEST_ERROR_FACTOR)
            return factor * step * step

        def keep_history(self, work: Any, i: Any, step: Any, reached: Reached, mask: Any) -> None:
            rate = self.stage_rates(step, 0.0).inertia_rate
            forces = (reached.velocity - work.velocity_predictor[i]) * rate
            work.acceleration[FORCES, i] = where(mask, forces, work.acceleration[FORCES, i])

        def error_power(self) -> float:
            return 3.0

    @property
    def damping_at_infinity(self) -> float:
        return self.spectral_radius

    def scheme(self) -> Scheme:
        """The scheme for the kernels."""
        rho = self.spectral_radius
        alpha_m = (2.0 * rho - 1.0) / (rho + 1.0)
        alpha_f = rho / (rho + 1.0)
        drift = alpha_f - alpha_m
        return self.Scheme(0.25 * (1.0 + drift) * (1.0 + drift), 0.5 + drift, alpha_m, alpha_f)
