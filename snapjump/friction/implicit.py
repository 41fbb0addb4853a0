"""Implicit friction: normal force and velocity are the unknown ones of the stage."""

from typing import Any, NamedTuple

from snapjump.friction.base import regularised_sign
from snapjump.friction.parts.smoothed_coulomb import SmoothedCoulomb, SmoothedCoulombOptions
from snapjump.number.functions import absolute, any_true, maximum, where


class ImplicitFriction(SmoothedCoulombOptions):
    """Smoothed Coulomb friction of the unknown normal force and velocity."""

    @SmoothedCoulomb.member
    class Law(NamedTuple):
        """Coefficient mu and velocity threshold eps_v (in L/T) of smoothed Coulomb friction."""

        mu: float
        velocity_threshold: float

        def slope(self, velocity: Any, previous: Any) -> Any:
            sign, slope = regularised_sign(velocity, self.velocity_threshold)
            # Newton would jump to and fro across the stick zone: after a change of sign, take the
            # chord from rest.
            turned = velocity * previous < 0.0
            if any_true(turned):
                chord = absolute(sign) / maximum(absolute(velocity), 1e-300 + 0.0 * velocity)
                slope = where(turned, maximum(chord, slope), slope)
            return self.mu * slope
