"""Drives, which turn the clamps over time, or move them apart: the contract that each fulfils."""

from typing import Any, ClassVar, NamedTuple

from snapjump.declare.fields import Part
from snapjump.number.methods import Contract, required


class ClampAngles(NamedTuple):
    """Angles (rad) of the left and right clamp against the frame, and their rates (rad/T); how much
    farther apart the clamps are than at the beginning (L), and the rate of that (L/T).

    The end tangents turn downwards: -left at s = 0, +right at s = L.
    """

    left: Any
    right: Any
    left_rate: Any
    right_rate: Any
    apart: Any = 0.0
    apart_rate: Any = 0.0


class Programme(Contract):
    """What the clamps do over time, in dimensionless numbers.

    One that turns them from a static start has ``start``, ``end`` and ``rate`` of the left clamp
    (rad, rad/T), and ``delta_alpha``, by which the right one lags at the beginning (rad).
    """

    @required
    def angles(self, time: Any) -> Any:
        """The :class:`ClampAngles` at a time (in T)."""

    def time_turned(self) -> Any:
        """Time (T) since the leading clamp was flat, at a march's beginning; of one or of many."""
        return 0.0

    def has_two_rates(self) -> bool:
        """Whether the right clamp has a rate of its own; a constant while compiling."""
        return False

    def right_over_left(self) -> Any:
        """The right clamp's rate over the left one's."""
        return 1.0

    def initial_share(self) -> Any:
        """Rate at a march's beginning over ``rate``; a constant while compiling."""
        return 0.0


class DriveOptions(Part):
    """A drive and its numbers."""

    group = "drive"
    differentiable = False
    turns: ClassVar[bool] = True  # the clamps, from an equilibrium
    held: ClassVar[bool] = False  # the arch, in the shape in which it snaps, until it is let go

    @required
    def programme(self, simulation: Any, start: Any) -> Any:
        """The dimensionless programme, a member of :class:`Programme`, of a simulation whose left
        clamp is at the angle ``start`` (rad) in the beginning; of many robots an array."""

    @property
    def in_common(self) -> tuple[str, Any]:
        """What all robots of a march have to share, in words and as a value: measured angles, or
        whether the right clamp has a rate of its own; nothing by default."""
        return "all", None

    @property
    def rate_rad_s(self) -> Any:
        """Rate of the left clamp, of a drive that turns it."""
        raise NotImplementedError

    @property
    def end_rad(self) -> Any:
        """Angle at which it stops."""
        raise NotImplementedError

    @property
    def delay_s(self) -> Any:
        """How much later than at that rate, at most, it is where it is to be."""
        return 0.0

    def start_rad(self, usual: Any) -> Any:
        """Angle of the left clamp at the beginning, where that is not the usual one."""
        return usual

    def rest(self, simulation: Any, arch: Any) -> Any:
        """The state (D) of a beam between clamps in space (a
        :class:`~snapjump.statics.arch.StaticArch`) at the beginning. Raises ArithmeticError where
        there is none."""
        return arch.flat(simulation.design.delta_alpha)
