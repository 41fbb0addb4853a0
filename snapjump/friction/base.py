"""Friction against the ground: the contract that every friction law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers. Forces are in EI/L^2, velocities in L/T.
"""

from typing import Any, ClassVar

from numba.extending import overload

from snapjump.declare.fields import Part
from snapjump.number.dispatch import INLINED, kernel
from snapjump.number.functions import absolute, where
from snapjump.number.methods import Contract, required
from snapjump.number.slope import derivative, slope_in, sloped
from snapjump.units import Scales


def derived_slope(law: Any, velocity: Any) -> Any:
    """The slope that follows from a law's friction ratio."""
    return derivative(law.ratio, velocity)


@overload(derived_slope, strict=False, jit_options=INLINED)
def _derived_slope(law: Any, velocity: Any) -> Any:
    return lambda law, velocity: slope_in(law.ratio(sloped(velocity, 1.0)))


class FrictionLaw(Contract):
    """Friction against the ground: the friction ratio of a sliding velocity."""

    def exists(self) -> Any:
        """Whether friction terms are compiled in."""
        return True

    def is_lagged(self) -> Any:
        """Whether normal force and velocity are those of the step's beginning."""
        return False

    @required
    def holds(self) -> Any:
        """Whether friction keeps a resting robot in its place (a mask)."""

    @required
    def ratio(self, velocity: Any) -> Any:
        """Friction force over normal force."""

    def stick_speed(self) -> Any:
        """Sliding velocity (L/T) below which friction sticks, which steps and iterations then
        resolve; 1e30 where nothing is to be resolved, or cannot be."""
        return 1e30

    def largest_ratio(self) -> Any:
        """Of friction force over normal force, at any velocity; 1e30 where that is not known."""
        return 1e30

    def slope(self, velocity: Any, previous: Any) -> Any:
        """Its derivative by the velocity.

        ``previous`` is the velocity at the Newton iterate before: a law may use it to linearise
        safely where its derivative jumps.
        """
        return derived_slope(self, velocity)


@kernel
def regularised_sign(velocity: Any, threshold: Any) -> Any:
    """Smoothed sign of the velocity and its slope: 2 v/e - v|v|/e^2 for |v| < e.

    The factor 2, missing in the paper's print, makes it continuously differentiable at |v| = e.
    """
    over = 1.0 / threshold  # of a robot: once for all its points
    w = velocity * over
    size = absolute(w)
    slipping = size >= 1.0
    sign = where(slipping, where(w > 0.0, 1.0, -1.0), w * (2.0 - size))
    slope = where(slipping, 0.0, (2.0 - 2.0 * size) * over)
    return sign, slope


class FrictionOptions(Part):
    """A friction law and its numbers."""

    group = "friction"
    absent: ClassVar[bool] = False
    takes_arrays: ClassVar[bool] = False  # whether one law is made of many coefficients

    @required
    def law(self, scales: Scales, mu: float) -> Any:
        """The dimensionless law: a member of :class:`FrictionLaw`."""
