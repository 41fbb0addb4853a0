"""A cell of the study: one composition over designs, with the time that each jump takes.

Times are those of the compiled kernels, on one core with eight lanes. A short batch is done
several times; the median counts.
"""

import statistics
from collections.abc import Mapping
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.designs import spread_designs
from experiments.errors import baseline_sweep
from snapjump.batch import simulate_batch, variants
from snapjump.studies.base import Row

LANES = 8
REPEATS = 3
KEPT = ("status", "x_bar", "y_bar", "newton_iterations", "steps")
# Seconds of kernel time from which one measurement is enough.
LONG = 1.0


def plan_batch(
    groups: Mapping[str, Any], designs: int, sweep: int, seed: int, lanes: int = LANES
) -> dict[str, Any]:
    """Inputs of a cell: ``designs`` spread over the ranges, the first points of the sweep."""
    return {"groups": groups, "designs": designs, "sweep": sweep, "seed": seed, "lanes": lanes}


def jump_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each jump; ``ms`` is its share of the kernel time, by Newton iterations."""
    designs = spread_designs(inputs["designs"], inputs["seed"])
    kinds = ["design"] * len(designs) + ["sweep"] * inputs["sweep"]
    if inputs["sweep"]:
        designs += baseline_sweep()[: inputs["sweep"]]
    base = composed(inputs["groups"])
    simulations = variants(base, designs)
    batches = [simulate_batch(simulations, inputs["lanes"])]
    while len(batches) < REPEATS and batches[0].march_seconds < LONG:
        batches.append(simulate_batch(simulations, inputs["lanes"]))
    seconds = statistics.median(batch.march_seconds for batch in batches)
    batch = batches[0]
    total = max(float(np.sum(batch.newton_iterations)), 1.0)
    return [
        {
            "kind": kind,
            "delta_alpha_rad": design[0],
            "epsilon": design[1],
            "mass_bar": design[2],
            "mu": design[3],
            **row,
            "ms": 1e3 * seconds * row["newton_iterations"] / total,
        }
        for kind, design, row in zip(kinds, designs, batch.rows(*KEPT), strict=True)
    ]
