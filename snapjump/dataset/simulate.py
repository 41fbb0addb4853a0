"""From designs to rows: the one place where a dataset meets the simulation."""

from typing import Any

import numpy as np

from snapjump.backend.scalar import ScalarBackend
from snapjump.batch import Batch, simulate_designs, variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.dataset.columns import INPUTS, Rows
from snapjump.dataset.specification import Specification
from snapjump.executor.base import Progress
from snapjump.plan.base import AXES, Range
from snapjump.scenes.frame_body import compression
from snapjump.statics.threshold_curve import ThresholdCurve


class Simulator:
    """Simulates any stretch of a plan.

    Its thresholds come from one curve over the plan's range, the same for every shard.
    """

    def __init__(self, specification: Specification):
        self.specification = specification
        epsilons = specification.ranges[AXES.index("epsilon")]
        self.curve = curve_over(specification.simulation, epsilons)

    def rows(self, first: int, last: int, progress: Progress | None) -> Rows:
        """The rows of designs first to last - 1."""
        designs = self.specification.plan.designs(first, last)
        base = self.specification.simulation
        batch = simulate_designs(
            base,
            designs,
            curve=self.curve,
            progress=None if progress is None else lambda share, text: progress(share),
            lanes=1 if isinstance(base.backend, ScalarBackend) else None,
            sensitivities=self.specification.sensitivities,
        )
        inputs = dict(zip(AXES, designs.T, strict=True))
        return {"index": np.arange(first, last), **inputs, **batch.columns(), **derivatives(batch)}


def curve_over(base: Simulation, epsilons: Range) -> ThresholdCurve | None:
    """Thresholds over a range of pre-compressions; None where some of it has none.

    Then each design's own is computed, and those without are told apart.
    """
    mass_bar = base.environment.mass_bar
    try:
        low, high = (compression(variant(base, (0.0, e, mass_bar, 0.0))) for e in epsilons)
        return ThresholdCurve.through(base.robot, base.discretization, low, high)
    except ParameterError:
        return None


def derivatives(batch: Batch) -> dict[str, Any]:
    """Sensitivities of the jumps, by column; none where none were asked for."""
    found = batch.sensitivities
    if found is None:
        return {}
    columns: dict[str, Any] = {
        f"d{apex}_d_{name}": values[:, k]
        for apex, values in (("x_bar", found.dx_bar), ("y_bar", found.dy_bar))
        for k, name in enumerate(INPUTS)
    }
    columns["graze_distance"] = found.graze_distance
    columns["differentiable"] = found.differentiable
    return columns
