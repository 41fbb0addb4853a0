"""A dead force and a moment at the free end of a cantilever."""

from typing import Any, NamedTuple

from snapjump.engine.load.base import Load


@Load.member
class TipLoad(NamedTuple):
    """Force components (EI/L^2) and moment (EI/L) at the last node."""

    force_x: float
    force_y: float
    moment: float

    def tip_load(self) -> Any:
        return self.force_x, self.force_y, self.moment
