"""No frame: loose nodes that only contact and friction act on."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
from snapjump.frame.base import Frame


@Frame.member
class NoFrame(NamedTuple):
    """Nothing is held."""

    def end_tangents(self, mesh: Any, load: Any, angles: Any, state: Any, rotations: Any) -> Any:
        zero = 0.0 * state[0]
        return EndTangents(zero, zero, zero, zero, zero, zero, zero, zero)
