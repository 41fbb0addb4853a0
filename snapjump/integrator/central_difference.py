"""Central differences (velocity Verlet): explicit, second order, stable up to h omega = 2.

    q_1 = q_0 + h v_0 + h^2/2 a_0
    a_1 = -M^-1 forces(q_1, v_0 + h a_0)
    v_1 = v_0 + h/2 (a_0 + a_1)

Forces that depend on the velocity see its prediction, so that a mode with stiffness k, damping c
and mass m is stable while h^2 k + 4 h c <= 4 m. The march computes that bound at every step from
the tangent stiffness, for which the stage's rate is 4/h, and holds the step to it.
"""

from typing import Any, NamedTuple

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.fields import Need
from snapjump.integrator.base import IntegratorOptions, Rates, Reached, TimeIntegrator
from snapjump.number.functions import fma

SMALLEST_STEP = 1.1e-6  # T: a jump in smaller ones leads nowhere


class CentralDifference(IntegratorOptions):
    """Explicit, second order, lumped masses: held to the stable step, which it computes."""

    order = 2
    a_stable = False
    damping_at_infinity = None
    differentiable = False
    needs = (
        Need(
            "frame",
            "explicit",
            "whose stable step an elastic frame's short stiff elements would make hopeless",
        ),
    )

    def check_with(self, simulation: Any) -> None:
        """Material damping stiffens the stretching so much that explicit steps lead nowhere."""
        damping, robot = simulation.damping, simulation.robot
        eta = damping.relaxation_s()
        if not simulation.sim.moves_a_beam or eta == 0.0:
            return
        rate = 2.0 * simulation.discretization.elements * np.sqrt(robot.stretching_stiffness_bar)
        time_s = robot.scales.time_s
        step_s, smallest_s = time_s / rate * time_s / rate / eta, SMALLEST_STEP * time_s
        if step_s < smallest_s:
            raise ParameterError(
                "damping",
                damping.name,
                f"none or mass_proportional with integrator=central_difference, which needs steps "
                f"of {step_s:.2g} s for damping.relaxation_time_s = {eta:g} at this mesh (at "
                f"least {smallest_s:.2g} s)",
            )

    @TimeIntegrator.member
    class Scheme(NamedTuple):
        """No numbers."""

        def slots(self) -> int:
            return 2

        def is_explicit(self) -> bool:
            return True

        def stage_rates(self, step: Any, ratio: Any) -> Any:
            return Rates(4.0 / step, 0.0 * step)

        def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
            coefficients[0] = step

        def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
            h = work.coefficients[0]
            a = work.acceleration[0, i]
            velocity = work.velocity[0, i]
            aim = fma(h, fma(0.5 * h, a, velocity), work.start[i])
            # The assembly finds the predicted velocity as (aim - position) rate_factor.
            return aim - 0.25 * h * fma(h, a, velocity), velocity, aim

        def reached(self, work: Any, i: Any, step: Any, rates: Any) -> Reached:
            before = work.acceleration[0, i]
            after = work.acceleration[1, i]
            return Reached(fma(0.5 * step, before + after, work.velocity[0, i]), after)

        def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
            return reached.acceleration - work.acceleration[0, i]

        def error_scale(self, step: Any, ratio: Any) -> Any:
            return step * step / 6.0

        def error_power(self) -> float:
            return 3.0

    def scheme(self) -> Scheme:
        """The scheme for the kernels."""
        return self.Scheme()
