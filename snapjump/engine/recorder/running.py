"""Figures that run along with every lane, and are kept of a robot when it leaves."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.clock import STAGE, STEPS
from snapjump.engine.recorder.base import Recorder
from snapjump.number.array import uncounted
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
from snapjump.number.methods import required


class Running(NamedTuple):
    """Of R robots in W lanes, K figures each: ``lanes``, a tuple of W; ``now`` (K, W), of the
    robots that the lanes carry; ``kept`` (R, K), of those that have left."""

    lanes: tuple[int, ...]
    now: NDArray[np.float64]
    kept: NDArray[np.float64]


def make_running(lanes: int, kept: NDArray[np.float64]) -> Running:
    """Figures of so many lanes, to be kept in an array (R, K) that threads share."""
    return Running((0,) * lanes, aligned_zeros((kept.shape[1], lanes)), kept)


@kernel
def figures_of(running: Running) -> Any:
    """The figures (K) as numbers of all lanes."""
    return view_numbers(running.now, running.lanes)


@kernel
def about_to_begin(work: Any, converged: Any) -> Any:
    """Mask: robots in the first stage of their first step, whose beginning is their start."""
    return converged & (work.clock[STEPS] < 1.0) & (work.clock[STAGE] == 1.0)


class RunningRecorder(Recorder):
    """Recorders of figures that run along; ``running``: these."""

    running: Running

    @required
    def record_beginning(self, model: Any, masses: Any, work: Any, begins: Any) -> None:
        """Called when robots (a mask) are about to begin, in the state of ``work.start``."""

    def record_robot(self, lane: Any, robot: Any) -> None:
        now = uncounted(self.running.now)
        for k in range(now.shape[0]):
            now[k, lane] = 0.0

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        begins = about_to_begin(work, converged)
        if any_true(begins):
            self.record_beginning(model, masses, work, begins)

    def record_end(self, model: Any, masses: Any, lane: Any, robot: Any) -> None:
        now = uncounted(self.running.now)
        kept = uncounted(self.running.kept)
        for k in range(now.shape[0]):
            kept[robot, k] = now[k, lane]
