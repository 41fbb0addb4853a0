"""When a march ends: the contract that every termination event fulfils."""

from typing import Any

from snapjump.number.methods import Contract, required


class Termination(Contract):
    """When a march ends: the contract that every termination event fulfils."""

    @required
    def time_limit(self, model: Any) -> Any:
        """No step goes beyond this time (T)."""

    @required
    def tolerance_factor(self, model: Any, work: Any) -> Any:
        """Factor by which a step's error may exceed the tolerance: above 1 where it can no longer
        change the result, below 1 where the result needs more."""

    def newton_tolerance(self, work: Any, tolerance: Any) -> Any:
        """Error (L) that Newton's method may leave in a stage, given the step control's own."""
        return tolerance

    @required
    def terminate(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        """Status (:mod:`snapjump.engine.status`) after an accepted step, which ``work.start`` and
        slot 0 hold the end of; 0 to go on."""
