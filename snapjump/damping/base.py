"""Material damping: the contract that every damping law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers; times are in T = L^2 sqrt(rho A / EI).
"""

from typing import Any

from snapjump.declare.fields import Part
from snapjump.number.methods import Contract, required
from snapjump.units import Scales


class DampingLaw(Contract):
    """Damping of the beam's material and of masses; by default there is none."""

    def viscous_strain(self, strain: Any, rate: Any) -> Any:
        """The strain that the elastic law turns into a stress: strain plus a share of its rate."""
        return strain

    def stiffening(self, rate_factor: Any) -> Any:
        """d viscous_strain / d strain when d rate / d strain is ``rate_factor``."""
        return 1.0

    def drags(self) -> Any:
        """Whether masses are damped; a constant while compiling."""
        return False

    def drag(self) -> Any:
        """Damping force over momentum (1/T)."""
        return 0.0


class DampingOptions(Part):
    """A damping law and its numbers."""

    group = "damping"

    @required
    def law(self, scales: Scales) -> Any:
        """The dimensionless law: a member of :class:`DampingLaw`."""

    def relaxation_s(self) -> float:
        """Stress by the strain's rate over stress by the strain (s)."""
        return 0.0
