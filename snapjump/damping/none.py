"""No damping: strain rates are not even computed."""

from typing import NamedTuple

from snapjump.damping.base import DampingLaw


@DampingLaw.member
class NoDamping(NamedTuple):
    """A perfectly elastic material in vacuum."""
