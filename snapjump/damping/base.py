"""Material damping: the contract that every damping law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers; times are in T = L^2 sqrt(rho A / EI).
"""

from typing import Any

from snapjump.number.dispatch import family_function


@family_function
def viscous_strain(damping: Any, strain: Any, rate: Any) -> Any:
    """The strain that the elastic law turns into a stress: strain plus a share of its rate."""


@family_function
def viscous_stiffening(damping: Any, rate_factor: Any) -> Any:
    """d viscous_strain / d strain when d rate / d strain is ``rate_factor``."""


@family_function
def mass_damping(damping: Any) -> Any:
    """Damping force over momentum (1/T)."""
