"""Two figures at every step of one robot: where the beam's middle is, and the ground's force.

They are kept for every accepted step, so that what is read from them (when the beam passes the
line of its mounts, the peak of the force) is interpolated to more than the integrator's order.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.clamp.base import clamp_angles
from snapjump.contact.base import contact_weights, force_if_acting, has_contact
from snapjump.discretization.base import clamp_offset
from snapjump.engine.assemble import Motion
from snapjump.engine.clock import STAGE, TIME
from snapjump.engine.powers import approach_of, frame_point, node_point
from snapjump.frame.base import (
    STILL,
    contact_points,
    end_tangents,
    frame_dofs,
    point_mass,
    point_weight,
)
from snapjump.integrator.base import stage_count
from snapjump.number.dispatch import kernel
from snapjump.number.functions import any_true, sqrt
from snapjump.recorder.base import (
    record_end,
    record_robot,
    record_stage,
    record_start,
    record_step,
)


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
    dofs = frame_dofs(model.frame, mesh)
    stride = (state.shape[0] - dofs) // nodes
    angles = clamp_angles(model.clamp, time)
    tangents = end_tangents(model.frame, mesh, model.load, angles, state, STILL)
    offset = clamp_offset(model.discretization)
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
def ground_force(model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any) -> Any:
    """Sum of the normal forces (EI/L^2) at all nodes and corners."""
    total = 0.0 * state[0]
    if has_contact(model.contact):
        mesh = work.mesh
        by_node, _ = contact_weights(model.contact)
        before = work.velocity[0]
        for node in range(masses.shape[0]):
            if masses[node] > 0.0:
                now = node_point(model, mesh, node, state, velocity)
                begun = node_point(model, mesh, node, work.start, before)
                approach = approach_of(motion, now, begun, masses[node])
                _, force, _ = force_if_acting(model.contact, now.gap, approach)
                total += by_node * force
        for point in range(contact_points(model.frame, mesh)):
            now = frame_point(model, mesh, point, state, velocity)
            begun = frame_point(model, mesh, point, work.start, before)
            mass = point_mass(model.frame, mesh, point, state)
            approach = approach_of(motion, now, begun, mass)
            _, force, _ = force_if_acting(model.contact, now.gap, approach)
            total += point_weight(model.frame, mesh, point, model.contact) * force
    return total


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


@record_start.member(ObservablesRecorder)
def _record_start(recorder: ObservablesRecorder, model: Any, masses: Any, work: Any) -> None:
    motion = Motion(work.clock[TIME], 0.0, 0.0, 0.0)
    observe(recorder, model, motion, masses, work, work.start, work.velocity[0])
    keep(recorder)


@record_stage.member(ObservablesRecorder)
def _record_stage(
    recorder: ObservablesRecorder,
    model: Any,
    masses: Any,
    motion: Any,
    scheme: Any,
    work: Any,
    converged: Any,
) -> None:
    last = stage_count(scheme)
    if any_true(work.clock[STAGE] >= 1.0 * last):
        observe(recorder, model, motion, masses, work, work.state, work.velocity[last])


@record_step.member(ObservablesRecorder)
def _record_step(recorder: ObservablesRecorder, scheme: Any, work: Any, good: Any) -> None:
    time = work.clock[TIME]
    if any_true(time > recorder.clock[0]):
        recorder.clock[0] = time
        keep(recorder)


@record_robot.member(ObservablesRecorder)
def _record_robot(recorder: ObservablesRecorder, lane: Any, robot: Any) -> None:
    pass


@record_end.member(ObservablesRecorder)
def _record_end(
    recorder: ObservablesRecorder, model: Any, masses: Any, lane: Any, robot: Any
) -> None:
    pass
