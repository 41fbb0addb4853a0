"""Quadratic penalty: E(d) = k d^2 / 2 for a negative gap d, a spring that is met at d = 0.

Conservative, so that a bounce has restitution 1; the ground is entered by v sqrt(m / k).
"""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw, ContactOptions, weighting
from snapjump.declare.fields import number
from snapjump.units import Scales


class Penalty(ContactOptions):
    """Quadratic penalty: a spring below the ground; conservative, fast, and it lets points sink in.

    ``stiffness_N_m`` as for the barrier.
    """

    stiffness_N_m: float = number(
        1.0e5, above=0.0, unit="N/m", doc="stiffness of the ground", symbol="k", plan=(5e4, 2e5),
        takes_arrays=True,
    )  # fmt: skip
    weighting: str = weighting()

    @ContactLaw.member
    class Law(NamedTuple):
        """Stiffness k (in EI/L^3)."""

        stiffness: float

        def energy(self, gap: Any) -> Any:
            return 0.5 * self.stiffness * gap * gap

        def force(self, gap: Any, state: Any) -> Any:
            return -self.stiffness * gap

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        return self.Law(stiffness=self.stiffness_N_m / scales.stiffness_N_m)
