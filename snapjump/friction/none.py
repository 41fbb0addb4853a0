"""No friction: every friction term is left out of the compiled program."""

from typing import Any, NamedTuple

from snapjump.friction.base import FrictionLaw, FrictionOptions
from snapjump.units import Scales


class NoFriction(FrictionOptions):
    """A perfectly slippery ground."""

    absent = True
    takes_arrays = True

    @FrictionLaw.member
    class Law(NamedTuple):
        """A perfectly slippery ground."""

        def exists(self) -> bool:
            return False

        def holds(self) -> bool:
            return False

        def largest_ratio(self) -> float:
            return 0.0

        def ratio(self, velocity: Any) -> Any:
            return 0.0 * velocity

        def slope(self, velocity: Any, previous: Any) -> Any:
            return 0.0 * velocity

    def law(self, scales: Scales, mu: float) -> Law:
        """The empty law."""
        return self.Law()
