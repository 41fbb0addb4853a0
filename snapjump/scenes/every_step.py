"""Every step of a recorded march, read between its slices: largest loads of all, and samples."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.recorder.trajectory import TrajectoryRecorder
from snapjump.scenes.runner import PASSES_PER_SLICE, March
from snapjump.scenes.trajectory import Samples, read

ROWS = PASSES_PER_SLICE + 3  # a step takes a pass at least; the last one before, and one to spare


class Row(NamedTuple):
    """A step's end: time, state, velocity, works, as :class:`Samples` has them of many."""

    time: float
    state: Array
    velocity: Array
    works: Array


@dataclass
class EveryStep:
    """``interval``: least time (T) between samples. Largest so far, dimensionless: ``turning`` of
    the beam over an element, at which ``node`` and ``when``; ``torque`` of a clamp; normal
    ``force`` of the ground, all points together."""

    march: March
    recorder: TrajectoryRecorder
    interval: float
    turning: float = 0.0
    node: int = 0
    when: float = 0.0
    torque: float = 0.0
    force: float = 0.0
    kept: list[Row] = field(default_factory=list)
    last: Row | None = None

    def __post_init__(self) -> None:
        self.march.after_slice = self.take

    def take(self) -> None:
        """Read the steps of a slice; the recorder goes on behind the last of them."""
        recorder = self.recorder
        first, count = int(self.last is not None), int(recorder.filled[0])
        if count <= first:
            return
        rows = slice(first, count)
        self.look(recorder.times[rows], recorder.states[rows], recorder.velocities[rows])
        columns = recorder.times, recorder.states, recorder.velocities, recorder.works
        for k in range(first, count):
            self.last = Row(*(column[k].copy() for column in columns))
            if not self.kept or self.last.time >= self.kept[-1].time + self.interval:
                self.kept.append(self.last)
        for column in columns:
            column[0] = column[count - 1]
        recorder.filled[0] = 1

    def look(self, times: Array, states: Array, velocities: Array) -> None:
        """Let loads of states and velocities (S, D) at times (S) count."""
        readings = read(self.march, times, states, velocities)
        bent = np.abs(readings.turnings)
        step, node = np.unravel_index(int(bent.argmax()), bent.shape)
        if bent[step, node] > self.turning:
            self.turning, self.node = float(bent[step, node]), int(node)
            self.when = float(times[step])
        self.torque = max(self.torque, float(np.abs(readings.torques).max()))
        self.force = max(self.force, float(readings.normal.sum(axis=1).max()))

    def samples(self) -> Samples:
        """What was kept, and the last step."""
        rows = list(self.kept)
        if self.last is not None and self.last is not rows[-1]:
            rows.append(self.last)
        return Samples(*(np.array(column) for column in zip(*rows, strict=True)))
