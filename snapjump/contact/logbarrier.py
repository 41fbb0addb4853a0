"""Logarithmic barrier: the paper's contact law (its eq. for E, the barrier of IPC).

E(d) = -K (d - d_hat)^2 log(d / d_hat) for 0 < d < d_hat, else 0. The energy, its first and its
second derivative vanish at d_hat; the force grows without bound as the gap closes, so that a gap
never becomes negative. The paper prints the bracket of dE/dd; the force is its negative.

Damping, if any, adds a viscous share of the stiffness: force - eta E''(d) d(d)/dt, never pulling.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw, ContactOptions, weighting
from snapjump.declare.fields import number
from snapjump.number.exponentials import log
from snapjump.number.functions import where
from snapjump.units import Scales


class LogBarrier(ContactOptions):
    """Logarithmic barrier (the paper, IPC): no gap ever closes.

    ``stiffness_N_m`` is K_c at a frame corner and at a node of the paper's mesh of 66 elements;
    per length it is spread so that refining the mesh does not stiffen the ground. ``damping_s``
    adds a force of so many seconds times the stiffness times the closing speed.
    """

    stiffness_N_m: float = number(
        1.0e4, above=0.0, unit="N/m", doc="barrier stiffness", symbol="K_c", plan=(5e3, 2e4),
        takes_arrays=True,
    )  # fmt: skip
    distance_m: float = number(
        5.0e-4,
        above=0.0,
        unit="m",
        doc="gap below which the ground pushes",
        symbol="d̂",
        plan=(2e-4, 1e-3),
        usual=(1e-9, 0.1),
        takes_arrays=True,
    )
    damping_s: float = number(
        0.0,
        least=0.0,
        unit="s",
        doc="of a viscous share of the stiffness",
        symbol="η_c",
        plan=(0.0, 1e-6),
        takes_arrays=True,
    )
    weighting: str = weighting()

    @ContactLaw.member
    class Law(NamedTuple):
        """Barrier stiffness K (in EI/L^3), distance d_hat (in L), relaxation time (in T)."""

        stiffness: float
        distance: float
        relaxation_time: float

        def keeps_open(self) -> bool:
            return True

        def reach(self) -> Any:
            return self.distance

        def energy(self, gap: Any) -> Any:
            depth = gap - self.distance
            return -self.stiffness * depth * depth * log(gap * (1.0 / self.distance))

        def elastic(self, gap: Any) -> Any:
            """The force at rest, -dE/dd."""
            depth = gap - self.distance
            logarithm = log(gap * (1.0 / self.distance))
            return self.stiffness * depth * (2.0 * logarithm + depth * (1.0 / gap))

        def curvature(self, gap: Any) -> Any:
            """d2E/dd2."""
            ratio = (gap - self.distance) * (1.0 / gap)
            logarithm = log(gap * (1.0 / self.distance))
            return self.stiffness * (ratio * ratio - 4.0 * ratio - 2.0 * logarithm)

        def total(self, gap: Any, state: Any) -> Any:
            """The force before it is kept from pulling."""
            viscous = self.relaxation_time * self.curvature(gap) * state.speed
            return self.elastic(gap) - viscous

        def force(self, gap: Any, state: Any) -> Any:
            total = self.total(gap, state)
            return where(total > 0.0, total, 0.0)

        def slope(self, gap: Any, state: Any) -> Any:
            over = 1.0 / gap
            ratio = (gap - self.distance) * over
            curvature = self.curvature(gap)
            sharpening = 2.0 * self.stiffness * ((ratio - 2.0) * (1.0 - ratio) - 1.0) * over
            viscous = curvature * state.rate + sharpening * state.speed
            slope = curvature + self.relaxation_time * viscous
            return where(self.total(gap, state) > 0.0, slope, 0.0)

        def loss(self, gap: Any, state: Any) -> Any:
            return (self.elastic(gap) - self.force(gap, state)) * state.speed

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        return self.Law(
            stiffness=self.stiffness_N_m / scales.stiffness_N_m,
            distance=self.distance_m / scales.length_m,
            relaxation_time=self.damping_s / scales.time_s,
        )
