"""Cone: a pointed foot that sinks into an elastic ground (Sneddon 1965)."""

from math import pi, tan
from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw, ContactOptions
from snapjump.declare.fields import number
from snapjump.units import Scales


class Cone(ContactOptions):
    """Cone: a pointed foot that sinks into an elastic ground."""

    modulus_Pa: float = number(1.0e8, above=0.0, unit="Pa", doc="E/(1 - nu^2)")
    half_angle_rad: float = number(0.8, least=0.1, most=1.5, unit="rad")

    @ContactLaw.member
    class Law(NamedTuple):
        """Stiffness k (in EI/L^4)."""

        stiffness: float

        def energy(self, gap: Any) -> Any:
            return -self.stiffness * gap * gap * gap / 3.0

        def force(self, gap: Any, state: Any) -> Any:
            return self.stiffness * gap * gap

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        stiffness = 2.0 / pi * self.modulus_Pa * tan(self.half_angle_rad)
        return self.Law(stiffness * scales.length_m / scales.stiffness_N_m)
