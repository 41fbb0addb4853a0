"""Jumps, and the path of the centre of mass up to lift-off."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.paper.jumps import jump_rows
from experiments.paper.settings import BASELINE, NAMES, RANGES
from snapjump.backend.scalar import ScalarBackend
from snapjump.batch import variant
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate

Design = tuple[float, ...]

FAMILIES: dict[str, tuple[float, ...]] = {
    "delta_alpha_rad": (0.0, 0.01, 0.05, 0.1, 0.19),
    "epsilon": (0.1, 0.2, 0.3),
    "mass_bar": (0.4, 0.768, 1.5),
}
# Paths of the centre of mass while the robot still touches the ground.
FOLLOWED = (0.0, 0.05, 0.1, 0.19)
ANGLES = 41  # mismatches from nothing to the end of the paper's range
STRIDE = 4  # every so many of them at reference
DESIGNS = 256  # over the paper's ranges, for how oblique a jump can be


def varied(name: str, values: Sequence[float]) -> list[Design]:
    """The baseline with these values of one number."""
    place = NAMES.index(name)
    return [(*BASELINE[:place], float(value), *BASELINE[place + 1 :]) for value in values]


def mismatches(stride: int = 1) -> list[Design]:
    """The baseline with mismatches from zero to the end of the paper's range."""
    values = np.linspace(0.0, RANGES["delta_alpha_rad"][1], ANGLES)
    return varied("delta_alpha_rad", values[::stride].tolist())


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
