"""``uncertainty=model``: the apex simulated again with each input off by its tolerance."""

from collections.abc import Mapping
from typing import Any

from snapjump.checks import ParameterError
from snapjump.declare.scenes import Progress
from snapjump.uncertainty.base import UncertaintyOptions
from snapjump.uncertainty.parts.simulated import check_base, model_uncertainty
from snapjump.uncertainty.parts.spread import ModelUncertainty
from snapjump.uncertainty.parts.tolerances import KEY, checked


class OfModel(UncertaintyOptions):
    """The apex simulated again with each input off by its tolerance, either way.

    ``tolerances``: beside, or in place of, those of
    :data:`snapjump.uncertainty.parts.tolerances.DEFAULTS`, by path; None leaves one out.
    """

    tolerances: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.tolerances is not None:
            if not isinstance(self.tolerances, Mapping):
                allowed = "null, or tolerances by path: {robot.thickness_m: {relative: 0.01}}"
                raise ParameterError(KEY, self.tolerances, allowed)
            object.__setattr__(self, "tolerances", dict(self.tolerances))

    def check_for(self, simulation: Any) -> None:
        checked(self.tolerances)
        check_base(simulation)

    def of(self, simulation: Any, progress: Progress | None = None) -> ModelUncertainty:
        return model_uncertainty(simulation, self.tolerances, progress)
