"""The contract of an uncertainty: how far an apex may be off by its model."""

from typing import Any

from snapjump.declare.fields import Part, required
from snapjump.declare.scenes import Progress
from snapjump.uncertainty.parts.spread import ModelUncertainty


class UncertaintyOptions(Part):
    """What is asked beside the numerical error, which every jump estimates."""

    group = "uncertainty"

    def check_for(self, simulation: Any) -> None:
        """Raises ParameterError for a simulation of which it cannot be told."""

    @required
    def of(self, simulation: Any, progress: Progress | None = None) -> ModelUncertainty | None:
        """The uncertainty of a simulation's apex, None where none is asked for."""
        raise NotImplementedError
