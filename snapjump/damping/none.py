"""No damping: strain rates are not even computed."""

from typing import NamedTuple

from snapjump.damping.base import DampingLaw, DampingOptions
from snapjump.units import Scales


class NoDamping(DampingOptions):
    """A perfectly elastic material."""

    @DampingLaw.member
    class Law(NamedTuple):
        """A perfectly elastic material in vacuum."""

    def law(self, scales: Scales) -> Law:
        """The empty law."""
        return self.Law()
