"""Jumps as rows: what the parts that simulate them keep of each."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.paper.settings import NAMES
from snapjump.batch import Batch, simulate_designs
from snapjump.composition import Simulation
from snapjump.engine import status
from snapjump.run.studies.base import Row
from snapjump.run.studies.base import column as numbers

__all__ = ["batch_rows", "furthest", "jump_rows", "numbers"]
# Results depend on neither: eight lanes are a tier's own program, and a second thread halves time.
LANES, THREADS = 8, 2
KEPT = (
    "status",
    "x_bar",
    "y_bar",
    "liftoff_x_bar",
    "liftoff_y_bar",
    "liftoff_vx_m_s",
    "liftoff_vy_m_s",
    "min_gap_m",
    "newton_iterations",
)


def batch_rows(batch: Batch) -> list[Row]:
    """A row for each jump: status, apex and lift-off of the centre of mass, smallest gap, cost."""
    return batch.rows(*KEPT)


def jump_rows(simulation: Simulation, designs: Sequence[Any], lanes: int = LANES) -> list[Row]:
    """The same of designs (delta_alpha, epsilon, m_bar, mu), with these four numbers."""
    table = np.asarray(designs, dtype=float)
    batch = simulate_designs(simulation, table, lanes=lanes, threads=THREADS)
    return [
        {**dict(zip(NAMES, design, strict=True)), **row}
        for design, row in zip(table.tolist(), batch_rows(batch), strict=True)
    ]


def furthest(rows: Sequence[Row], others: Sequence[Row], key: str, place: str) -> float:
    """The largest difference of a column between rows that agree in another column."""
    known = dict(zip(numbers(others, place).round(9), numbers(others, key), strict=True))
    pairs = zip(numbers(rows, place).round(9), numbers(rows, key), strict=True)
    return float(np.nanmax([abs(value - known[at]) for at, value in pairs if at in known]))


def apart(sweep: Mapping[str, Sequence[Row]], place: str) -> tuple[float, float]:
    """The largest differences of x and of y between standard and reference, where both are."""
    x, y = (furthest(sweep["standard"], sweep["reference"], k, place) for k in ("x_bar", "y_bar"))
    return x, y


def apexes_of(rows: Sequence[Row]) -> Any:
    """Apexes (R, 2) in L, NaN unless the robot jumps."""
    apexes = np.stack([numbers(rows, "x_bar"), numbers(rows, "y_bar")], axis=-1)
    apexes[[row["status"] != status.NAMES[status.OK] for row in rows]] = np.nan
    return apexes
