"""The released program's rows (``experiments/data/README.md``)."""

import csv
import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from snapjump.plan.parts.axes import default_axes

ROWS = Path(__file__).resolve().parents[1] / "data" / "released_rows.csv"
PARAMETERS = tuple(axis.column for axis in default_axes())


@dataclass(frozen=True)
class Rows:
    """R designs (delta_alpha in rad, epsilon, m_bar, mu), and their apex over L (R)."""

    designs: list[tuple[float, float, float, float]]
    x_bar: NDArray[np.float64]
    y_bar: NDArray[np.float64]


def read_rows(count: int, path: Path = ROWS) -> Rows:
    """``count`` rows spread evenly over the file; all of them if it has no more."""
    with path.open(newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    places = np.unique(np.linspace(0, len(rows) - 1, min(count, len(rows))).round().astype(int))
    chosen = [rows[k] for k in places]
    return Rows(
        [tuple(row[key] for key in PARAMETERS) for row in chosen],
        np.array([row["x_bar"] for row in chosen]),
        np.array([row["y_bar"] for row in chosen]),
    )


def digest() -> str:
    """Hash of the file: what is kept of a study is void when the data change."""
    return hashlib.sha256(ROWS.read_bytes()).hexdigest()[:16]
