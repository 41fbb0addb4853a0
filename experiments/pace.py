"""How long one core takes for a jump, beside how long the jump lasts."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from snapjump.batch import simulate_designs
from snapjump.run.studies.base import Row, column

from .compositions import composed


def pace_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each design: how long its jump lasts, and how long one core takes for it alone."""
    base, designs = composed(inputs["groups"]), np.array(inputs["designs"])
    simulate_designs(base, designs[:1], lanes=1)  # compiled before it is timed
    keys = ("status", "apex_time_s", "liftoff_time_s", "kernel_seconds")
    return [simulate_designs(base, one[None], lanes=1).rows(*keys)[0] for one in designs]


def pace_row(rows: Sequence[Row]) -> Row:
    """Times of several jumps: how long they last, and how long they take."""
    apex, takeoff, taken = (
        column(rows, key) for key in ("apex_time_s", "liftoff_time_s", "kernel_seconds")
    )
    return {
        "jumps": len(rows),
        "apex_median_s": float(np.median(apex)),
        "liftoff_median_s": float(np.median(takeoff)),
        "computed_median_s": float(np.median(taken)),
        "computed_most_s": float(np.max(taken)),
        "most_of_time_to_apex": float(np.max(taken / apex)),
        "most_of_time_to_liftoff": float(np.max(taken / takeoff)),
    }
