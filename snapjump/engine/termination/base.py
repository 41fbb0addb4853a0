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
        """Factor (at least 1) by which a step's error may exceed the tolerance: what can no longer
        change the result need not be resolved."""

    @required
    def terminate(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        """Status (:mod:`snapjump.engine.status`) after an accepted step, 0 to go on."""
