"""Rotation of the clamps over time: the contract that every rotation programme fulfils."""

from typing import Any, NamedTuple

from snapjump.number.methods import Contract, required


class ClampAngles(NamedTuple):
    """Angles (rad) of the left and right clamp against the frame, and their rates (rad/T).

    The end tangents turn downwards: -left at s = 0, +right at s = L.
    """

    left: Any
    right: Any
    left_rate: Any
    right_rate: Any


class ClampProgramme(Contract):
    """Rotation of the clamps over time: the contract that every rotation programme fulfils."""

    @required
    def angles(self, time: Any) -> Any:
        """The :class:`ClampAngles` at a time (in T)."""
