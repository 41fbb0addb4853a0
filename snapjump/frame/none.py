"""No frame: loose nodes that only contact and friction act on."""

from typing import Any, NamedTuple

from snapjump.discretization.base import EndTangents
from snapjump.frame.base import condense_first, condense_last, end_tangents, place_ends
from snapjump.frame.immovable import immovable


@immovable
class NoFrame(NamedTuple):
    """Nothing is held."""


@end_tangents.member(NoFrame)
def _end_tangents(
    frame: NoFrame, mesh: Any, load: Any, angles: Any, state: Any, turning: Any
) -> Any:
    zero = 0.0 * state[0]
    return EndTangents(zero, zero, zero, zero, zero, zero, zero, zero)


@place_ends.member(NoFrame)
def _place_ends(frame: NoFrame, mesh: Any, discretization: Any, angles: Any, state: Any) -> None:
    pass


@condense_first.member(NoFrame)
def _condense_first(
    frame: NoFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    pass


@condense_last.member(NoFrame)
def _condense_last(
    frame: NoFrame,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> None:
    pass
