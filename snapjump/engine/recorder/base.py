"""Recorders of a march: the contract that every one fulfils.

They are chosen by class, so that a march without one is compiled without any trace of them.
"""

from typing import Any

from snapjump.number.methods import Contract


class Recorder(Contract):
    """Recorders of a march: the contract that every one fulfils."""

    def watches(self) -> Any:
        """Whether anything is recorded; a constant while compiling."""
        return True

    def record_robot(self, lane: Any, robot: Any) -> None:
        """Called when a lane has been given a robot of the queue."""

    def record_start(self, model: Any, masses: Any, work: Any) -> None:
        """Called once before the first step."""

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        """Called when stages have converged, before the clock's stage moves on."""

    def follow(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, course: Any, good: Any
    ) -> None:
        """Called when converged stages have been judged, before steps that stand (``good``) are
        committed; ``course``: the :class:`~snapjump.engine.stage.Course` of the stages."""

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        """Called when steps have been judged; ``good``: mask of those that stand, committed."""

    def record_end(self, model: Any, masses: Any, lane: Any, robot: Any) -> None:
        """Called when a robot is about to leave its lane."""
