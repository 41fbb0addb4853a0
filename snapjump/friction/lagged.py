"""Lagged friction: the paper's, with normal force and velocity of the step's beginning.

It is explicit, hence unstable for steps above eps_v m / (mu N).
"""

from typing import Any, NamedTuple

from snapjump.friction.base import FrictionLaw, regularised_sign


@FrictionLaw.member
class LaggedFriction(NamedTuple):
    """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

    mu: float
    velocity_threshold: float

    def is_lagged(self) -> bool:
        return True

    def holds(self) -> Any:
        return self.mu > 0.0

    def ratio(self, velocity: Any) -> Any:
        sign, _ = regularised_sign(velocity, self.velocity_threshold)
        return self.mu * sign

    def slope(self, velocity: Any, previous: Any) -> Any:
        return 0.0 * velocity
