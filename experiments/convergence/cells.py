"""A cell of the study: one jump and its observables."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import composed
from snapjump.scenes.observed import observe_jump
from snapjump.studies.base import Row

OBSERVABLES = ("snap_time_s", "peak_force_N", "liftoff_speed_m_s", "x_bar", "y_bar")
COSTS = ("steps", "newton_iterations", "kernel_seconds")


def observed_row(groups: Mapping[str, Any]) -> Row:
    """Status, observables and cost of the composition's jump."""
    seen = observe_jump(composed(groups))
    return {key: seen[key] for key in ("status", *OBSERVABLES, *COSTS)}
