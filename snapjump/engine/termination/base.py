"""When a march ends: the contract that every ending fulfils (a ``NamedTuple`` of numbers)."""

from typing import Any

from snapjump.number.methods import Contract, required


class Ending(Contract):
    """When a march ends: the contract that every ending fulfils (a ``NamedTuple`` of numbers)."""

    @required
    def time_limit(self, model: Any) -> Any:
        """No step goes beyond this time (T)."""

    @required
    def leniency(self, model: Any, work: Any) -> Any:
        """Factor (at least 1) by which a step's error may exceed the tolerance: what can no longer
        change the result need not be resolved."""

    @required
    def judge(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        """Status (:mod:`snapjump.engine.status`) after an accepted step, 0 to go on."""
