"""Implicit friction: normal force and velocity are the unknown ones of the stage."""

from typing import Any, NamedTuple

from snapjump.friction.base import regularised_sign
from snapjump.friction.parts.smoothed_coulomb import SmoothedCoulomb, SmoothedCoulombOptions
from snapjump.number.functions import where


class ImplicitFriction(SmoothedCoulombOptions):
    """Smoothed Coulomb friction of the unknown normal force and velocity."""

    @SmoothedCoulomb.member
    class Law(NamedTuple):
        """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

        mu: float
        velocity_threshold: float

        def slope(self, velocity: Any, previous: Any) -> Any:
            _, slope = regularised_sign(velocity, self.velocity_threshold)
            # Newton would jump to and fro across the stick zone: after a change of sign, use the
            # slope at rest, the steepest there is.
            slope = where(velocity * previous < 0.0, 2.0 / self.velocity_threshold, slope)
            return self.mu * slope
