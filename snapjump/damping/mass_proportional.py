"""Mass-proportional damping: a drag on every mass, as in the released program."""

from typing import Any, NamedTuple

from snapjump.damping.base import DampingLaw, DampingOptions
from snapjump.declare.fields import number
from snapjump.units import Scales


class MassProportional(DampingOptions):
    """A drag on every mass (the released program: 0.01 1/s)."""

    rate_1_s: float = number(
        0.01, least=0.0, unit="1/s", doc="drag over momentum", symbol="c", plan=(0.0, 1.0),
        takes_arrays=True,
    )  # fmt: skip

    @DampingLaw.member
    class Law(NamedTuple):
        """Drag coefficient (in 1/T)."""

        rate: float

        def drags(self) -> bool:
            return True

        def drag(self) -> Any:
            return self.rate

    def law(self, scales: Scales) -> Law:
        """The dimensionless law."""
        return self.Law(self.rate_1_s * scales.time_s)
