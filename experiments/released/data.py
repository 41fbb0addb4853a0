"""The released program's rows (``experiments/data/README.md``), and how far jumps are from them.

Differences are in percent; those of x relative to max(|x|, 0.1 y), since x goes through zero.
"""

import csv
import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.arrays import Array

from ..designs import COLUMNS, Design
from ..errors import scale_of_x

ROWS = Path(__file__).resolve().parents[1] / "data" / "released_rows.csv"


@dataclass(frozen=True)
class Rows:
    """R designs (delta_alpha in rad, epsilon, mass_bar, mu), and their apex over L (R)."""

    designs: list[Design]
    x_bar: Array
    y_bar: Array


def read_rows(count: int, path: Path = ROWS) -> Rows:
    """``count`` rows spread evenly over the file; all of them if it has no more."""
    with path.open(newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    places = np.unique(np.linspace(0, len(rows) - 1, min(count, len(rows))).round().astype(int))
    chosen = [rows[k] for k in places]
    designs: Any = [tuple(row[key] for key in COLUMNS) for row in chosen]
    return Rows(designs, *(np.array([row[key] for row in chosen]) for key in ("x_bar", "y_bar")))


def digest() -> str:
    """Hash of the file: what is kept of a study is void when the data change."""
    return hashlib.sha256(ROWS.read_bytes()).hexdigest()[:16]


def differences(x: Array, y: Array, x_rows: Array, y_rows: Array) -> tuple[Array, Array]:
    """Signed differences of x and y (%), NaN where a jump failed."""
    return 100.0 * (x - x_rows) / scale_of_x(x_rows, y_rows), 100.0 * (y - y_rows) / y_rows


def figures(x: Array, y: Array) -> dict[str, Any]:
    """Medians and percentiles of signed differences; failures are counted, not averaged."""
    row: dict[str, Any] = {}
    for name, values in (("x", x), ("y", y)):
        known = values[np.isfinite(values)]
        shares = np.percentile(np.abs(known), (50, 90, 95)) if len(known) else [None] * 3
        words = ("median", "p90", "p95")
        row |= {f"{name}_{word}_percent": share for word, share in zip(words, shares, strict=True)}
        row[f"{name}_bias_percent"] = float(np.median(known)) if len(known) else None
    return {**row, "failed": int(np.sum(~np.isfinite(x)))}


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
