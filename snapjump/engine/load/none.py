"""No load."""

from typing import NamedTuple

from snapjump.engine.load.base import Load


@Load.member
class NoLoad(NamedTuple):
    """Weightless and unloaded."""
