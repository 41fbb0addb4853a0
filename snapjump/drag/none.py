"""No drag: a jump in vacuum."""

from typing import Any, NamedTuple

from snapjump.drag.base import DragLaw, DragOptions
from snapjump.units import Scales


class NoDrag(DragOptions):
    """A jump in vacuum, whose flight is a parabola (the paper's)."""

    absent = True

    @DragLaw.member
    class Law(NamedTuple):
        """A jump in vacuum."""

    def law(self, scales: Scales, mass_kg: Any, plate_m2: Any) -> Law:
        """The empty law."""
        return self.Law()
