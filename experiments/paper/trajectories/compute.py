"""Jumps, and the path of the centre of mass up to lift-off."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.paper.jumps import jump_rows
from snapjump.backend.scalar import ScalarBackend
from snapjump.batch import variant
from snapjump.simulation import simulate
from snapjump.studies.base import Row

INTERVAL_S = 5e-5  # between the samples of a path


def rows_of(inputs: Mapping[str, Any]) -> list[Row]:
    """Of designs their jumps; of one design, followed, the path."""
    if "followed" in inputs:
        return path_rows(inputs["groups"], inputs["followed"])
    return jump_rows(composed(inputs["groups"]), inputs["designs"])


def path_rows(groups: Mapping[str, Any], design: list[float]) -> list[Row]:
    """The centre of mass from the start of the motion until nothing can touch any more."""
    base = composed(groups)
    one = replace(
        variant(base, design),
        sim=base.sim.changed(sample_interval_s=INTERVAL_S),
        backend=ScalarBackend(),
    )
    result = simulate(one)
    length, kept = base.robot.length_m, result.arrays
    loads = kept["node_normal_N"].sum(axis=1) + kept["corner_normal_N"].sum(axis=1)
    columns = np.stack(
        [
            1e3 * kept["time_s"],
            kept["com_x_m"] / length,
            kept["com_y_m"] / length,
            loads,
        ],
        axis=1,
    )
    keys = ("time_ms", "x_bar", "y_bar", "ground_force_N")
    return [dict(zip(keys, row, strict=True)) for row in columns.tolist()]
