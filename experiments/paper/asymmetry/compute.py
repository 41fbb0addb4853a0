"""A cell: snaps at one setting and pre-compression, from hardly any mismatch to a large one."""

from collections.abc import Mapping
from typing import Any

from experiments.paper.settings import snap_of
from snapjump.run.studies.base import Row
from snapjump.scenes.swing import follow, outcome


def sweep_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each mismatch: :func:`experiments.paper.swing.outcome`."""
    return [
        {
            "delta_alpha_rad": lag,
            **outcome(follow(snap_of(inputs["groups"], inputs["epsilon"], lag))),
        }
        for lag in inputs["mismatches_rad"]
    ]
