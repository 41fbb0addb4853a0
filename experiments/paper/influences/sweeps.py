"""The sweeps: one number of the baseline each, over the paper's range and somewhat beyond."""

from dataclasses import dataclass

import numpy as np

MOUNT_HEIGHT = "mount_height_bar"


@dataclass(frozen=True)
class Sweep:
    """``count`` values from ``first`` to ``last``; every ``stride``-th of them at reference."""

    first: float
    last: float
    count: int
    stride: int
    label: str

    def values(self, stride: int = 1) -> list[float]:
        """The places, clean of rounding, so that a coarse sweep has places of the fine one."""
        places = np.linspace(self.first, self.last, self.count)[::stride]
        return [float(value) for value in places.round(9)]


SWEEPS = {
    MOUNT_HEIGHT: Sweep(0.01, 0.34, 133, 4, "mount height h / L"),
    "epsilon": Sweep(0.1, 0.3, 81, 4, "pre-compression ε"),
    "delta_alpha_rad": Sweep(0.0, 0.3, 101, 4, "mismatch Δα (rad)"),
    "mu": Sweep(0.0, 1.0, 101, 4, "friction coefficient μ"),
    "mass_bar": Sweep(0.3, 2.0, 86, 5, "mass m̄"),
}
# Of these the contact is looked into: friction against which way the beam slides, and how the
# ground bears the beam before it snaps.
SLIDING_MU = (0.1, 0.2, 0.25, 0.3, 0.45, 0.6)
PRESSED_HEIGHTS = (0.03, 0.05, 0.07, 0.15)
# Of these the energy is followed: the ends of the paper's range, and the baseline.
ENERGY_MASSES = (0.3, 0.768, 2.0)
