"""How far jumps are from the released program's rows, in percent.

Differences of x are relative to max(|x|, 0.1 y), since x goes through zero.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def differences(x: Array, y: Array, x_rows: Array, y_rows: Array) -> tuple[Array, Array]:
    """Signed differences of x and y (%), NaN where a jump failed."""
    scale = np.maximum(np.abs(x_rows), 0.1 * y_rows)
    return 100.0 * (x - x_rows) / scale, 100.0 * (y - y_rows) / y_rows


def figures(x: Array, y: Array) -> dict[str, Any]:
    """Medians and percentiles of signed differences; failures are counted, not averaged."""
    row: dict[str, Any] = {}
    for name, values in (("x", x), ("y", y)):
        known = values[np.isfinite(values)]
        size = np.abs(known)
        row[f"{name}_median_percent"] = float(np.median(size)) if len(known) else None
        row[f"{name}_p90_percent"] = float(np.percentile(size, 90)) if len(known) else None
        row[f"{name}_p95_percent"] = float(np.percentile(size, 95)) if len(known) else None
        row[f"{name}_bias_percent"] = float(np.median(known)) if len(known) else None
    row["failed"] = int(np.sum(~np.isfinite(x)))
    return row


def by_quarter(values: Array, x: Array, y: Array, name: str) -> list[dict[str, Any]]:
    """Figures in each quarter of a parameter's range: where what is left comes from."""
    edges = np.quantile(values, [0.0, 0.25, 0.5, 0.75, 1.0])
    rows = []
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        inside = (values >= low) & ((values < high) | (high == edges[-1]))
        rows.append(
            {"parameter": name, "from": float(low), "to": float(high), "rows": int(inside.sum())}
            | figures(x[inside], y[inside])
        )
    return rows


def share_within(values: Sequence[float] | Array, bound: float) -> float:
    """Share (%) of differences within a bound, failures counting as outside."""
    return float(100.0 * np.mean(np.abs(np.nan_to_num(np.asarray(values), nan=np.inf)) <= bound))
