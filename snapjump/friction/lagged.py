"""Lagged friction: the paper's, with normal force and velocity of the step's beginning.

It is explicit, hence unstable for steps above eps_v m / (mu N).
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import Need
from snapjump.friction.parts.smoothed_coulomb import SmoothedCoulomb, SmoothedCoulombOptions


class LaggedFriction(SmoothedCoulombOptions):
    """Smoothed Coulomb friction of the last step's normal force and velocity (the paper)."""

    needs = (
        Need("contact", "force_is_of_position", "which uses the force of the position a step ago"),
    )

    @SmoothedCoulomb.member
    class Law(NamedTuple):
        """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

        mu: float
        velocity_threshold: float

        def is_lagged(self) -> bool:
            return True

        def slope(self, velocity: Any, previous: Any) -> Any:
            return 0.0 * velocity
