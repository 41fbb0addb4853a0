"""Newmark's method: generalized-alpha without its weights of forces and accelerations."""

import numpy as np

from snapjump.checks import check_number
from snapjump.declare.fields import number
from snapjump.integrator.base import IntegratorOptions
from snapjump.integrator.generalized_alpha import GeneralizedAlpha


class Newmark(IntegratorOptions):
    """Newmark's method: average acceleration by default, second order, damps nothing.

    Second order for ``gamma`` = 1/2; A-stable for 2 ``beta`` >= ``gamma`` >= 1/2.
    """

    beta: float = number(0.25, least=0.25, most=1.0)
    gamma: float = number(0.5, least=0.5, most=1.0)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_number("integrator.beta", self.beta, 0.5 * self.gamma, 1.0)

    @property
    def order(self) -> int:
        return 2 if self.gamma == 0.5 else 1

    @property
    def damping_at_infinity(self) -> float:
        """Spectral radius for infinitely fast oscillations."""
        return largest_root(self.beta, self.gamma)

    def scheme(self) -> GeneralizedAlpha.Scheme:
        """The scheme for the kernels."""
        return GeneralizedAlpha.Scheme(self.beta, self.gamma, 0.0, 0.0)


def largest_root(beta: float, gamma: float) -> float:
    """Spectral radius of Newmark's method as the frequency goes to infinity."""
    # lambda^2 + ((gamma + 1/2) / beta - 2) lambda + 1 - (gamma - 1/2) / beta = 0
    roots = np.roots([1.0, (gamma + 0.5) / beta - 2.0, 1.0 - (gamma - 0.5) / beta])
    return float(np.abs(roots).max())
