"""The cells of a study as records nested below the study's own."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from snapjump.run.studies.base import Done

TOLD = ("status", "message", "started_at", "finished_at")


def children(
    cells: Iterable[Done], metrics: Mapping[str, Mapping[str, float]]
) -> list[dict[str, Any]]:
    """One record a cell: its inputs, its status, and its numbers.
    Of each numeric column the median is recorded; ``metrics`` adds what the study made of it."""
    return [
        {
            "name": done.cell.name,
            **{key: getattr(done, key) for key in TOLD},
            "params": dict(done.cell.inputs),
            "metrics": {**medians(done), **_finite(metrics.get(done.cell.name, {}))},
        }
        for done in cells
    ]


def medians(done: Done) -> dict[str, float]:
    """The median of every column whose entries are numbers or null; columns of nulls are left."""
    import pandas as pd

    return pd.DataFrame(done.rows).select_dtypes("number").median().dropna().to_dict()


def _finite(metrics: Mapping[str, float]) -> dict[str, float]:
    return {key: float(value) for key, value in metrics.items() if np.isfinite(value)}
