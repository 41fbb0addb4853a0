"""Hunt and Crossley (1975): a Hertzian spring whose damping grows with the penetration p.

f = k p^(3/2) (1 + lambda dp/dt) for p = -gap > 0, never pulling: no force at first touch and none
at separation. A mass that enters at speed v leaves at e v, where, for whatever mass, stiffness and
exponent, (1 + e) lambda v = log((1 + lambda v) / (1 - e lambda v)): slower impacts rebound better.
"""

import math
from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw, ContactOptions, weighting
from snapjump.declare.fields import number
from snapjump.number.functions import sqrt, where
from snapjump.number.portable import log1p
from snapjump.units import Scales


def damping_number(restitution: float) -> float:
    """Damping times impact speed, u, for which (1 + e) u = log((1 + u) / (1 - e u))."""
    from scipy.optimize import brentq

    if restitution == 1.0:
        return 0.0

    def excess(u: float) -> float:
        return log1p(u) - log1p(-restitution * u) - (1.0 + restitution) * u

    # Towards u = 0 the excess is (e^2 - 1) u^2 / 2 < 0, towards 1/e it grows without bound.
    low, high = min(1e-3, 0.1 * (1.0 - restitution)), (1.0 - 1e-15) / restitution
    if excess(high) < 0.0 or excess(low) > 0.0:
        # Rounding hides the root: it is 1/e for small e, and nothing as e comes near 1.
        return high if excess(high) < 0.0 else 0.0
    return float(brentq(excess, low, high, xtol=1e-15))


class HuntCrossley(ContactOptions):
    """Hunt-Crossley: a Hertzian spring with a damper that gives an impact its restitution.

    ``stiffness_N_m``: force over penetration at ``penetration_m``; ``restitution`` of an impact at
    ``impact_speed_m_s`` (slower ones lose less).
    """

    restitution: float = number(
        0.8, least=0.01, most=1.0, doc="of an impact", symbol="e", plan=(0.5, 1.0)
    )
    impact_speed_m_s: float = number(
        5.0,
        above=0.0,
        unit="m/s",
        doc="speed that the restitution is of",
        symbol="v_e",
        plan=(2.0, 10.0),
        takes_arrays=True,
    )
    stiffness_N_m: float = number(
        1.0e5, above=0.0, unit="N/m", doc="force over penetration", symbol="k", plan=(5e4, 2e5),
        takes_arrays=True,
    )  # fmt: skip
    penetration_m: float = number(
        2.0e-5,
        above=0.0,
        unit="m",
        doc="penetration that the stiffness is of",
        symbol="p",
        plan=(1e-5, 4e-5),
    )
    weighting: str = weighting()

    @ContactLaw.member
    class Law(NamedTuple):
        """Stiffness k (in EI/L^(7/2)), damping lambda (in T/L)."""

        stiffness: float
        damping: float

        def energy(self, gap: Any) -> Any:
            return 0.4 * self.stiffness * gap * gap * sqrt(-gap)

        def elastic(self, gap: Any) -> Any:
            """The force at rest."""
            return -self.stiffness * gap * sqrt(-gap)

        def force(self, gap: Any, state: Any) -> Any:
            factor = 1.0 - self.damping * state.speed
            return where(factor > 0.0, self.elastic(gap) * factor, 0.0)

        def slope(self, gap: Any, state: Any) -> Any:
            factor = 1.0 - self.damping * state.speed
            lost = self.elastic(gap) * self.damping * state.rate
            slope = 1.5 * self.stiffness * sqrt(-gap) * factor + lost
            return where(factor > 0.0, slope, 0.0)

        def loss(self, gap: Any, state: Any) -> Any:
            return (self.elastic(gap) - self.force(gap, state)) * state.speed

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        secant = self.stiffness_N_m / scales.stiffness_N_m
        speed = self.impact_speed_m_s / scales.velocity_m_s
        return self.Law(
            stiffness=secant / math.sqrt(self.penetration_m / scales.length_m),
            damping=damping_number(self.restitution) / speed,
        )
