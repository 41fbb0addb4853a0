"""The trajectory of one robot, with its energy ledger.

The works of friction, damping and clamps are integrated by the quadrature of the integrator
itself, stage by stage, so that what they leave unexplained is the integrator's own dissipation.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.assemble import Motion, assemble
from snapjump.engine.clock import LARGEST_RESIDUAL, STAGE, STEP, TIME
from snapjump.engine.powers import powers
from snapjump.engine.recorder.base import Recorder
from snapjump.engine.view import without_matrix
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, any_true, maximum

LEDGER = 5  # works of friction, damping, clamps, contact, drag


@Recorder.member
class TrajectoryRecorder(NamedTuple):
    """Samples, at most S of them, and the ledger between them.

    interval (1): least time between samples (T); filled (1): samples so far; times (S); states,
    velocities (S, D); works (S, 5): of friction, damping, clamps, contact, drag since the start
    (EI/L); totals, pending (5): works committed and of the step under way; powers_at_start,
    powers_now (5): at the step's beginning and at its last stage; clock (1): time up to which works
    are committed.
    """

    interval: NDArray[np.float64]
    filled: NDArray[np.int64]
    times: NDArray[np.float64]
    states: NDArray[np.float64]
    velocities: NDArray[np.float64]
    works: NDArray[np.float64]
    totals: NDArray[np.float64]
    pending: NDArray[np.float64]
    powers_at_start: NDArray[np.float64]
    powers_now: NDArray[np.float64]
    clock: NDArray[np.float64]

    def record_start(self, model: Any, masses: Any, work: Any) -> None:
        motion = Motion(work.clock[TIME], 0.0, 0.0, 0.0)
        now = powers(model, motion, masses, work, work.start, work.velocity[0])
        for w in range(LEDGER):
            self.powers_at_start[w] = now[w]
        keep_sample(self, work)

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        if not scheme.is_explicit():
            assembly = assemble(model, motion, masses, without_matrix(work))
            left = 0.0
            if model.frame.border_width() > 0:
                left = largest_entry(work.frame_residual, left)
            left = largest_entry(work.residual, left) / (assembly.largest_force + 1e-300)
            work.clock[LARGEST_RESIDUAL] = maximum(work.clock[LARGEST_RESIDUAL], left)
        stage = int(work.clock[STAGE])
        step = work.clock[STEP]
        now = powers(model, motion, masses, work, work.state, work.velocity[stage])
        for w in range(LEDGER):
            self.powers_now[w] = now[w]
        for w in range(LEDGER):
            if stage == 1:
                self.pending[w] = step * scheme.quadrature_weight(0) * self.powers_at_start[w]
            self.pending[w] += step * scheme.quadrature_weight(stage) * self.powers_now[w]

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        if any_true(good):
            time = work.clock[TIME]
            self.clock[0] = time
            for w in range(LEDGER):
                self.totals[w] += self.pending[w]
                self.powers_at_start[w] = self.powers_now[w]
            last = self.times[self.filled[0] - 1]
            room = self.filled[0] < self.times.shape[0] - 1
            if room and time >= last + self.interval[0]:
                keep_sample(self, work)


def make_recorder(size: int, duration: float, interval: float) -> TrajectoryRecorder:
    """A recorder for D = ``size`` coordinates, a duration and an interval of samples (T)."""
    return recorder_of(size, int(duration / interval) + 16, interval)


def recorder_of(size: int, samples: int, interval: float = 0.0) -> TrajectoryRecorder:
    """A recorder for so many samples, of every step if there is no interval."""
    return TrajectoryRecorder(
        interval=np.array([interval]),
        filled=np.zeros(1, dtype=np.int64),
        times=np.empty(samples),
        states=np.empty((samples, size)),
        velocities=np.empty((samples, size)),
        works=np.empty((samples, LEDGER)),
        totals=np.zeros(LEDGER),
        pending=np.zeros(LEDGER),
        powers_at_start=np.zeros(LEDGER),
        powers_now=np.zeros(LEDGER),
        clock=np.zeros(1),
    )


@kernel
def largest_entry(values: Any, largest: Any) -> Any:
    """The largest absolute value, or ``largest`` if that is larger."""
    for i in range(values.shape[0]):
        largest = maximum(largest, absolute(values[i]))
    return largest


@kernel
def keep_sample(recorder: Any, work: Any) -> None:
    """Copy the state at the step's beginning into the next sample."""
    k = recorder.filled[0]
    recorder.times[k] = work.clock[TIME]
    for i in range(work.state.shape[0]):
        recorder.states[k, i] = work.start[i]
        recorder.velocities[k, i] = work.velocity[0, i]
    for w in range(LEDGER):
        recorder.works[k, w] = recorder.totals[w]
    recorder.filled[0] = k + 1
