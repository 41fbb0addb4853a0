"""Quadratic penalty: E(d) = k d^2 / 2 for a negative gap d, a spring that is met at d = 0.

Conservative, so that a bounce has restitution 1; the ground is entered by v sqrt(m / k).
"""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw


@ContactLaw.member
class Penalty(NamedTuple):
    """Stiffness k (in EI/L^3)."""

    stiffness: float

    def energy(self, gap: Any) -> Any:
        return 0.5 * self.stiffness * gap * gap

    def force(self, gap: Any, approach: Any) -> Any:
        return -self.stiffness * gap
