"""Options of the integrators that are no Runge-Kutta methods."""

from typing import ClassVar

import numpy as np

from snapjump.checks import check_number
from snapjump.declare.fields import Part, number
from snapjump.integrator.bdf2 import Bdf2
from snapjump.integrator.central_difference import CentralDifference
from snapjump.integrator.generalized_alpha import GeneralizedAlpha


class IntegratorOptions(Part):
    """An integrator and its numbers."""

    group = "integrator"


class Bdf2Options(IntegratorOptions):
    """Second order, one stage, two steps; L-stable; steps may vary."""

    order: ClassVar[int] = 2
    stages: ClassVar[int] = 1
    a_stable: ClassVar[bool] = True
    damping_at_infinity: ClassVar[float] = 0.0

    def scheme(self) -> Bdf2:
        """The scheme for the kernels."""
        return Bdf2()


class NewmarkOptions(IntegratorOptions):
    """Newmark's method: average acceleration by default, second order, damps nothing.

    Second order for ``gamma`` = 1/2; A-stable for 2 ``beta`` >= ``gamma`` >= 1/2.
    """

    beta: float = 0.25
    gamma: float = number(0.5, least=0.5, most=1.0)
    stages: ClassVar[int] = 1

    def __post_init__(self) -> None:
        super().__post_init__()
        check_number("integrator.beta", self.beta, 0.5 * self.gamma, 1.0)

    @property
    def order(self) -> int:
        return 2 if self.gamma == 0.5 else 1

    @property
    def a_stable(self) -> bool:
        return True

    @property
    def damping_at_infinity(self) -> float:
        """Spectral radius for infinitely fast oscillations."""
        return largest_root(self.beta, self.gamma)

    def scheme(self) -> GeneralizedAlpha:
        """The scheme for the kernels."""
        return GeneralizedAlpha(self.beta, self.gamma, 0.0, 0.0)


def largest_root(beta: float, gamma: float) -> float:
    """Spectral radius of Newmark's method as the frequency goes to infinity."""
    # lambda^2 + ((gamma + 1/2) / beta - 2) lambda + 1 - (gamma - 1/2) / beta = 0
    roots = np.roots([1.0, (gamma + 0.5) / beta - 2.0, 1.0 - (gamma - 0.5) / beta])
    return float(np.abs(roots).max())


class GeneralizedAlphaOptions(IntegratorOptions):
    """Generalized-alpha (Chung and Hulbert): second order, damps fast modes as much as is wanted.

    ``spectral_radius``: amplification of an infinitely fast oscillation.
    """

    spectral_radius: float = number(0.5, least=0.0, most=1.0)
    order: ClassVar[int] = 2
    stages: ClassVar[int] = 1
    a_stable: ClassVar[bool] = True

    @property
    def damping_at_infinity(self) -> float:
        return self.spectral_radius

    def scheme(self) -> GeneralizedAlpha:
        """The scheme for the kernels."""
        rho = self.spectral_radius
        alpha_m = (2.0 * rho - 1.0) / (rho + 1.0)
        alpha_f = rho / (rho + 1.0)
        drift = alpha_f - alpha_m
        return GeneralizedAlpha(0.25 * (1.0 + drift) * (1.0 + drift), 0.5 + drift, alpha_m, alpha_f)


class CentralDifferenceOptions(IntegratorOptions):
    """Explicit, second order, lumped masses: held to the stable step, which it computes."""

    order: ClassVar[int] = 2
    stages: ClassVar[int] = 1
    a_stable: ClassVar[bool] = False
    damping_at_infinity: ClassVar[float | None] = None

    def scheme(self) -> CentralDifference:
        """The scheme for the kernels."""
        return CentralDifference()
