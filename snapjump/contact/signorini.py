"""Signorini's condition with Newton's impact law: the rigid ground.

Gap and force exclude each other, 0 <= gap - target _|_ force >= 0. At a step's end the target is
the ground; where the gap would close within the step at the speed it has, it is the place that the
rebound velocity -e v leads to, gap_0 - h e v (Moreau 1988, Jean 1999: an impact law of velocities,
which implicit Euler turns into one of positions). The complementarity function
force - max(0, force_0 + r (target - gap)) is solved by a non-smooth Newton method with force_0 = 0
and r far above the inertia: the gap misses its target by a millionth of a step's travel.

A skin of a few nanometres keeps that miss from making a gap negative.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw, ContactOptions
from snapjump.declare.fields import Need, number
from snapjump.number.functions import maximum, where
from snapjump.units import Scales

STIFFER_THAN_INERTIA = 1e6

STATIC_STIFFNESS = 1e8  # EI/L^3

SKIN = 1e-6  # L


class Signorini(ContactOptions):
    """The rigid ground: a complementarity of gap and force, and Newton's impact law.

    ``restitution``: of every impact of a node or a corner.
    """

    per_length = False
    force_is_of_position = False
    differentiable = False
    needs = (
        Need(
            "integrator",
            "velocities_at_step_ends",
            "whose impact law is one of velocities between the ends of a step",
        ),
    )

    restitution: float = number(
        1.0, least=0.0, most=1.0, doc="of every impact", symbol="e", plan=(0.0, 1.0),
        takes_arrays=True,
    )  # fmt: skip

    @ContactLaw.member
    class Law(NamedTuple):
        """Restitution e."""

        restitution: float

        def is_constraint(self) -> bool:
            return True

        def reach(self) -> float:
            return SKIN

        def target(self, state: Any) -> Any:
            """The gap that the step must not end below."""
            rate = state.rate
            step = where(rate > 0.0, 1.0 / maximum(rate, 1e-300 + 0.0 * rate), 0.0)
            closing = state.start_gap + step * state.start_speed < SKIN
            falling = state.start_speed < 0.0
            rebound = state.start_gap - self.restitution * step * state.start_speed
            return where(closing & falling & (rebound > SKIN), rebound, SKIN)

        def active(self, gap: Any, state: Any) -> Any:
            return gap < self.target(state)

        def energy(self, gap: Any) -> Any:
            return 0.0 * gap

        def force(self, gap: Any, state: Any) -> Any:
            return self.slope(gap, state) * (self.target(state) - gap)

        def slope(self, gap: Any, state: Any) -> Any:
            return STATIC_STIFFNESS + STIFFER_THAN_INERTIA * state.inertia

        def loss(self, gap: Any, state: Any) -> Any:
            # A constant force over the step, along which the speed jumps.
            return -0.5 * self.force(gap, state) * (state.speed + state.start_speed)

        def bounce_rate_squared(self, stiffness: Any, mass: Any, speed: Any) -> Any:
            return 0.0 * speed

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        return self.Law(self.restitution)
