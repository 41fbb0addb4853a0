"""What robots of a march bear, recorded while they jump: only what is asked for."""

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.recorder import clamps, elastic, ground, momentum, strain
from snapjump.engine.recorder.both import BothRecorders
from snapjump.engine.recorder.running import Running, make_running
from snapjump.scenes.runner import March


class Kind(NamedTuple):
    """Of a recorder: how many figures it keeps of a robot, and what makes one of figures that run
    along, for chains of so many nodes."""

    figures: int
    make: Callable[[Running, int], Any]


def whatever_the_chain(recorder: Callable[[Running], Any]) -> Callable[[Running, int], Any]:
    """What makes a recorder that is the same for all chains."""
    return lambda running, nodes: recorder(running)


# By what outputs say that they read.
KINDS = {
    "bending": Kind(strain.FIGURES, strain.make_strain_recorder),
    "clamping": Kind(clamps.FIGURES, whatever_the_chain(clamps.ClampRecorder)),
    "push": Kind(ground.FIGURES, whatever_the_chain(ground.GroundRecorder)),
    "impulse": Kind(momentum.FIGURES, whatever_the_chain(momentum.MomentumRecorder)),
    "release": Kind(elastic.FIGURES, whatever_the_chain(elastic.ElasticRecorder)),
}


def record_loads(march: March, reads: Sequence[str]) -> dict[str, Array]:
    """Let a march record; to be called before it runs. Returns what it will fill: by each of
    ``reads`` the figures (R, K) of its robots, NaN of those that do not march."""
    robots, nodes = len(march.models), len(march.masses)
    kept = {read: np.full((robots, KINDS[read].figures), np.nan) for read in reads}
    for worker in march.crew:
        running = [make_running(march.lanes, kept[read]) for read in reads]
        recorders = [KINDS[r].make(own, nodes) for r, own in zip(reads, running, strict=True)]
        worker.recorder = reduce(BothRecorders, recorders)
    return kept
