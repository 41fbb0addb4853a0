"""A cell of the study: one composition over designs, with the time that each jump takes.

Times are those of the compiled kernels, on one core with eight lanes. A short batch is done
several times; the median counts.
"""

import statistics
from collections.abc import Mapping
from typing import Any

from snapjump.batch import simulate_batch, variants
from snapjump.run.studies.base import Cell, Row

from ..compositions import composed
from ..designs import COLUMNS, baseline_sweep, spread_designs

LANES = 8
REPEATS = 3
KEPT = ("status", "x_bar", "y_bar", "newton_iterations", "steps")
# Seconds of kernel time from which one measurement is enough.
LONG = 1.0


def batch_cell(
    name: str, groups: Mapping[str, Any], designs: int, sweep: int, seed: int, lanes: int = LANES
) -> Cell:
    """``designs`` spread over the ranges, and the first points of the sweep."""
    inputs = {"groups": groups, "designs": designs, "sweep": sweep, "seed": seed, "lanes": lanes}
    return Cell(name, inputs)


def jump_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each jump; ``ms`` is its share of the kernel time, by Newton iterations."""
    designs = spread_designs(inputs["designs"], inputs["seed"])
    kinds = ["design"] * len(designs) + ["sweep"] * inputs["sweep"]
    designs += baseline_sweep()[: inputs["sweep"]]
    simulations = variants(composed(inputs["groups"]), designs)
    batches = [simulate_batch(simulations, inputs["lanes"])]
    while len(batches) < REPEATS and batches[0].march_seconds < LONG:
        batches.append(simulate_batch(simulations, inputs["lanes"]))
    seconds = statistics.median(batch.march_seconds for batch in batches)
    total = max(float(batches[0].newton_iterations.sum()), 1.0)
    return [
        {
            "kind": kind,
            **dict(zip(COLUMNS, design, strict=True)),
            **row,
            "ms": 1e3 * seconds * row["newton_iterations"] / total,
        }
        for kind, design, row in zip(kinds, designs, batches[0].rows(*KEPT), strict=True)
    ]
