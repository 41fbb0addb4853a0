"""From designs to rows: the one place where a dataset meets the simulation."""

from typing import Any

import numpy as np

from snapjump.batch import simulate_batch, variants
from snapjump.dataset.columns import Rows
from snapjump.dataset.specification import Specification
from snapjump.executor.base import Progress
from snapjump.plan.base import AXES


class Simulator:
    """Simulates any stretch of a plan."""

    def __init__(self, specification: Specification):
        self.specification = specification

    def rows(self, first: int, last: int, progress: Progress | None) -> Rows:
        """The rows of designs first to last - 1."""
        designs = self.specification.plan.designs(first, last)
        base = self.specification.simulation
        batch = simulate_batch(variants(base, designs.tolist()), getattr(base.backend, "width", 1))
        share = batch.newton_iterations / max(1.0, batch.newton_iterations.sum())
        found: dict[str, Any] = {
            "index": np.arange(first, last),
            "x_bar": batch.x_bar,
            "y_bar": batch.y_bar,
            "status": np.array(batch.status, dtype=object),
            "steps": batch.steps.astype(np.int64),
            "newton_iterations": batch.newton_iterations.astype(np.int64),
            "kernel_seconds": batch.kernel_seconds * share,
            "x_error_estimate_percent": batch.estimate.x_percent,
            "y_error_estimate_percent": batch.estimate.y_percent,
            "within_tier": batch.estimate.within_tier,
        }
        return {**dict(zip(AXES, designs.T, strict=True)), **found}
