"""Two figures at every step of one robot: where the beam's middle is, and the ground's force.

They are kept for every accepted step, so that what is read from them (when the beam passes the
line of its mounts, the peak of the force) is interpolated to more than the integrator's order.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import STAGE, TIME
from snapjump.engine.points import ground_force
from snapjump.engine.recorder.base import Recorder
from snapjump.frame.base import STILL
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true, sqrt


@Recorder.member
class ObservablesRecorder(NamedTuple):
    """At most S steps.

    filled (1): steps so far, which may exceed S; times (S) (T); heights (S): of the middle above
    the line through both mounts (L); forces (S): normal force of the ground on the whole robot
    (EI/L^2); pending (3): the same of the last stage; clock (1): time of the last entry.
    """

    filled: NDArray[np.int64]
    times: NDArray[np.float64]
    heights: NDArray[np.float64]
    forces: NDArray[np.float64]
    pending: NDArray[np.float64]
    clock: NDArray[np.float64]

    def record_start(self, model: Any, masses: Any, work: Any) -> None:
        motion = Motion(work.clock[TIME], 0.0, 0.0, 0.0)
        observe(self, model, motion, masses, work, work.start, work.velocity[0])
        keep(self)

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        last = scheme.stage_count()
        if any_true(work.clock[STAGE] >= 1.0 * last):
            observe(self, model, motion, masses, work, work.state, work.velocity[last])

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        time = work.clock[TIME]
        if any_true(time > self.clock[0]):
            self.clock[0] = time
            keep(self)


def make_observables(steps: int) -> ObservablesRecorder:
    """A recorder for S = ``steps``."""
    return ObservablesRecorder(
        filled=np.zeros(1, dtype=np.int64),
        times=np.empty(steps),
        heights=np.empty(steps),
        forces=np.empty(steps),
        pending=np.zeros(3),
        clock=np.zeros(1),
    )


@kernel
def middle_height(model: Any, mesh: Any, time: Any, state: Any, nodes: Any) -> Any:
    """Distance (L) of the beam's middle from the line through both mounts, positive above."""
    dofs = model.frame.dofs(mesh)
    stride = (state.shape[0] - dofs) // nodes
    angles = model.clamp.angles(time)
    tangents = model.frame.end_tangents(mesh, model.load, angles, state, STILL)
    offset = model.discretization.clamp_distance()
    first = dofs
    last = dofs + stride * (nodes - 1)
    left_x = state[first] - offset * tangents.left_x
    left_y = state[first + 1] - offset * tangents.left_y
    along_x = state[last] + offset * tangents.right_x - left_x
    along_y = state[last + 1] + offset * tangents.right_y - left_y
    before = dofs + stride * ((nodes - 1) // 2)
    after = dofs + stride * (nodes // 2)
    x = 0.5 * (state[before] + state[after]) - left_x
    y = 0.5 * (state[before + 1] + state[after + 1]) - left_y
    return (along_x * y - along_y * x) / sqrt(along_x * along_x + along_y * along_y)


@kernel
def observe(
    recorder: Any, model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any
) -> None:
    """Keep the figures of a state until it is known whether its step stands."""
    recorder.pending[0] = motion.time
    recorder.pending[1] = middle_height(model, work.mesh, motion.time, state, masses.shape[0])
    recorder.pending[2] = ground_force(model, motion, masses, work, state, velocity)


@kernel
def keep(recorder: Any) -> None:
    """Make the pending figures the next entry, if there is room."""
    k = recorder.filled[0]
    if k < recorder.times.shape[0]:
        recorder.times[k] = recorder.pending[0]
        recorder.heights[k] = recorder.pending[1]
        recorder.forces[k] = recorder.pending[2]
    recorder.filled[0] = k + 1
