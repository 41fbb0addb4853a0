"""Hunt and Crossley (1975): a Hertzian spring whose damping grows with the penetration p.

f = k p^(3/2) (1 + lambda dp/dt) for p = -gap > 0, never pulling: no force at first touch and none
at separation. A mass that enters at speed v leaves at e v, where, for whatever mass, stiffness and
exponent, (1 + e) lambda v = log((1 + lambda v) / (1 - e lambda v)): slower impacts rebound better.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw
from snapjump.number.functions import sqrt, where


@ContactLaw.member
class HuntCrossley(NamedTuple):
    """Stiffness k (in EI/L^(7/2)), damping lambda (in T/L)."""

    stiffness: float
    damping: float

    def energy(self, gap: Any) -> Any:
        return 0.4 * self.stiffness * gap * gap * sqrt(-gap)

    def elastic(self, gap: Any) -> Any:
        """The force at rest."""
        return -self.stiffness * gap * sqrt(-gap)

    def force(self, gap: Any, approach: Any) -> Any:
        factor = 1.0 - self.damping * approach.speed
        return where(factor > 0.0, self.elastic(gap) * factor, 0.0)

    def slope(self, gap: Any, approach: Any) -> Any:
        factor = 1.0 - self.damping * approach.speed
        lost = self.elastic(gap) * self.damping * approach.rate
        slope = 1.5 * self.stiffness * sqrt(-gap) * factor + lost
        return where(factor > 0.0, slope, 0.0)

    def loss(self, gap: Any, approach: Any) -> Any:
        return (self.elastic(gap) - self.force(gap, approach)) * approach.speed
