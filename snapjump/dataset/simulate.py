"""From designs to rows: the one place where a dataset meets the simulation."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from snapjump.backend.scalar import ScalarBackend
from snapjump.batch import Batch, simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.dataset.columns import APEX, Rows, slope_columns
from snapjump.dataset.specification import Specification
from snapjump.declare.inputs import with_inputs
from snapjump.declare.scenes import Progress
from snapjump.plan.parts.axes import Axis
from snapjump.scenes.frame_body import compression
from snapjump.statics.threshold_curve import ThresholdCurve


class ShardSimulator:
    """Simulates any stretch of a plan.

    Its thresholds come from one curve over the plan's pre-compressions, the same for every shard;
    but where the beam varies, each design has its own.
    """

    def __init__(self, specification: Specification):
        self.specification = specification
        self.curve = curve_over(specification.simulation, specification.axes)

    def rows(self, first: int, last: int, progress: Progress | None) -> Rows:
        """The rows of designs first to last - 1."""
        designs = self.specification.plan.designs(first, last)
        base = self.specification.simulation
        batch = simulate_designs(
            base,
            designs,
            inputs=[axis.path for axis in self.specification.axes],
            curve=self.curve,
            progress=progress,
            lanes=1 if isinstance(base.backend, ScalarBackend) else None,
            sensitivities=self.specification.sensitivities,
            outputs=self.specification.outputs,
        )
        axes = self.specification.axes
        inputs = {axis.column: values for axis, values in zip(axes, designs.T, strict=True)}
        slopes = derivatives(batch, axes)
        return {"index": np.arange(first, last), **inputs, **batch.columns(), **slopes}


def curve_over(base: Simulation, axes: Sequence[Axis]) -> ThresholdCurve | None:
    """Thresholds over a range of pre-compressions; None where some of it has none, or there is but
    one.

    Then each design's own is computed, and those without are told apart.
    """
    ranges = [axis.range for axis in axes if axis.path == "design.epsilon"]
    if not ranges:
        return None
    try:
        low, high = (compression(with_inputs(base, {"design.epsilon": e})) for e in ranges[0])
        return ThresholdCurve.through(base.robot, base.discretization, low, high)
    except ParameterError:
        return None


def derivatives(batch: Batch, axes: Sequence[Axis]) -> dict[str, Any]:
    """Sensitivities of the jumps, by column; none where none were asked for."""
    found = batch.sensitivities
    if found is None:
        return {}
    columns: dict[str, Any] = {}
    for apex, values in zip(APEX, (found.dx_bar, found.dy_bar), strict=True):
        columns |= dict(zip(slope_columns(apex, axes), values.T, strict=True))
    columns["graze_distance"] = found.graze_distance
    columns["differentiable"] = found.differentiable
    return columns
