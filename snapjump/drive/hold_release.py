"""An arch that is held in the shape in which it snaps, its clamps turned on beyond, and let go."""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.drive.base import ClampAngles, DriveOptions, Programme


class HoldRelease(DriveOptions):
    """Clamps that stand ``beyond_rad`` past the angle at which the arch snaps, as it is let go.

    Until then it was held in the shape that it has at that angle. A little beyond the fold it is
    slow: Gomez, Moulton and Vella, Nature Physics 2017.
    """

    turns = False
    held = True

    beyond_rad: float = number(
        0.01, above=0.0, most=1.0, unit="rad", doc="turn of the clamps beyond the snap",
        symbol="Δα₊", plan=(1e-3, 0.1), kind="control",
    )  # fmt: skip

    @Programme.member
    class Law(NamedTuple):
        """Angles of both clamps (rad)."""

        left: float
        right: float

        def angles(self, time: Any) -> Any:
            still = 0.0 * time
            return ClampAngles(self.left + still, self.right + still, still, still, 0.0, 0.0)

    def programme(self, simulation: Any, start: Any) -> Law:
        """The dimensionless programme; ``start``: where the arch snaps."""
        left = start + self.beyond_rad
        return self.Law(left, left - simulation.design.delta_alpha)
