"""Random environments with targets that a hidden random design reaches."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from snapjump.batch import simulate_designs
from snapjump.composition import Simulation
from snapjump.plan.base import Range, stretched

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Problems:
    """``hidden`` (N, 4): designs as everywhere; ``targets`` (N, 2): where they get to, in L."""

    hidden: Array
    targets: Array


def make_problems(
    base: Simulation, ranges: tuple[Range, ...], seed: int, first: int, last: int
) -> Problems:
    """Problems first to last - 1 of a seed; the same whichever others are asked for.

    Raises RuntimeError if a hidden design does not jump, for then its target is none.
    """
    unit = np.array([np.random.default_rng([seed, k]).random(4) for k in range(first, last)])
    hidden = stretched(unit, ranges)
    batch = simulate_designs(base, hidden, threads=1)
    targets = np.column_stack([batch.x_bar, batch.y_bar])
    if not all(status == "ok" for status in batch.status):
        raise RuntimeError(f"hidden designs failed: {sorted(set(batch.status))}")
    return Problems(hidden, targets)
