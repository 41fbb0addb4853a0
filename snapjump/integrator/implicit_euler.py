"""Implicit Euler: the paper's integrator."""

from dataclasses import dataclass
from typing import ClassVar

from snapjump.integrator.base import Integrator


@dataclass(frozen=True)
class ImplicitEuler(Integrator):
    """First order, one stage: damps every mode like Kelvin-Voigt damping with eta = h."""

    rows: ClassVar = ((0.0,), (0.0, 1.0))
    order: ClassVar = 1
    damping_at_infinity: ClassVar = 0.0
