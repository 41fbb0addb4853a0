"""Mass-proportional damping: a drag on every mass, as in the released program."""

from typing import Any, NamedTuple

from snapjump.damping.base import DampingLaw


@DampingLaw.member
class MassProportional(NamedTuple):
    """Drag coefficient (in 1/T)."""

    rate: float

    def drag(self) -> Any:
        return self.rate
