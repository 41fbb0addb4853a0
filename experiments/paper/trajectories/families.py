"""Designs that differ from the baseline in one number, and those of the sweep of the mismatch."""

from collections.abc import Sequence

import numpy as np

from experiments.paper.baseline import BASELINE, NAMES, RANGES

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
