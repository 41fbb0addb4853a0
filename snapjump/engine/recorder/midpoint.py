"""The trajectory of a beam, and its midpoint at every step: where and how fast it is, how tilted.

What is read off the midpoint (when it passes its clamps, how far it tilts) then does not depend on
how far apart samples are kept.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.clock import TIME
from snapjump.engine.recorder.base import Recorder
from snapjump.engine.recorder.trajectory import TrajectoryRecorder
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true

HEIGHT, SPEED, CHORD_X, CHORD_Y = range(4)


@Recorder.member
class MidpointRecorder(NamedTuple):
    """Of at most K steps, the first one the start.

    trajectory: its samples; filled (1): steps so far; times (K) (T); figures (K, 4): height of the
    midpoint (L), its vertical velocity (L/T), and x and y of the chord of the two elements that
    meet there, or of the middle one (L).
    """

    trajectory: TrajectoryRecorder
    filled: NDArray[np.int64]
    times: NDArray[np.float64]
    figures: NDArray[np.float64]

    def record_start(self, model: Any, masses: Any, work: Any) -> None:
        self.trajectory.record_start(model, masses, work)
        keep_midpoint(self, model, masses, work)

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        self.trajectory.record_stage(model, masses, motion, scheme, work, converged)

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        before = self.trajectory.clock[0]
        self.trajectory.record_step(model, masses, scheme, work, good)
        if any_true(work.clock[TIME] > before):
            keep_midpoint(self, model, masses, work)


def make_midpoint_recorder(trajectory: TrajectoryRecorder, steps: int) -> MidpointRecorder:
    """A recorder for so many steps beside the start; memory that is not touched costs nothing."""
    return MidpointRecorder(
        trajectory,
        filled=np.zeros(1, dtype=np.int64),
        times=np.empty(steps + 1),
        figures=np.empty((steps + 1, 4)),
    )


@kernel
def keep_midpoint(recorder: Any, model: Any, masses: Any, work: Any) -> None:
    """Add the state at the step's beginning to the figures."""
    stride = model.discretization.node_dofs()
    offset = model.frame.dofs(work.mesh)
    last = masses.shape[0] - 1
    y = offset + 1
    one = stride * (last // 2)
    other = stride * ((last + 1) // 2)
    before = stride * ((last + 1) // 2 - 1)
    after = stride * (last // 2 + 1)
    state = work.start
    k = recorder.filled[0]
    recorder.times[k] = work.clock[TIME]
    recorder.figures[k, HEIGHT] = 0.5 * (state[y + one] + state[y + other])
    recorder.figures[k, SPEED] = 0.5 * (work.velocity[0, y + one] + work.velocity[0, y + other])
    recorder.figures[k, CHORD_X] = state[offset + after] - state[offset + before]
    recorder.figures[k, CHORD_Y] = state[y + after] - state[y + before]
    recorder.filled[0] = k + 1
