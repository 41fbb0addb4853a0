"""What robots of a march bear, recorded while they jump: only what is asked for."""

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.recorder import clamps, elastic, ground, momentum, strain
from snapjump.engine.recorder.both import BothRecorders
from snapjump.scenes.runner import March


class Kind(NamedTuple):
    """Of a recorder: how many figures it keeps of a robot, and what makes one of so many lanes, for
    an array (R, figures) and chains of so many nodes."""

    figures: int
    make: Callable[[int, Array, int], Any]


# By what outputs say that they read.
KINDS = {
    "bending": Kind(strain.FIGURES, strain.make_strain_recorder),
    "clamping": Kind(clamps.FIGURES, clamps.make_clamp_recorder),
    "push": Kind(ground.FIGURES, ground.make_ground_recorder),
    "impulse": Kind(momentum.FIGURES, momentum.make_momentum_recorder),
    "release": Kind(elastic.FIGURES, elastic.make_elastic_recorder),
}


def record_loads(march: March, reads: Sequence[str]) -> dict[str, Array]:
    """Let a march record; to be called before it runs. Returns what it will fill: by each of
    ``reads`` the figures (R, K) of its robots, NaN of those that do not march."""
    robots, nodes = len(march.models), len(march.masses)
    kept = {read: np.full((robots, KINDS[read].figures), np.nan) for read in reads}
    for worker in march.crew:
        recorders = [KINDS[read].make(march.lanes, kept[read], nodes) for read in reads]
        worker.recorder = reduce(BothRecorders, recorders)
    return kept
