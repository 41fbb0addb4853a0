"""Derivatives of where every robot's centre of mass flies, by four parameters.

The march itself is not touched: it takes the same steps with and without this recorder.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.contact.base import contact_reach
from snapjump.discretization.base import node_dofs
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.clock import MARK
from snapjump.engine.differentiate import commit, differentiate_stages
from snapjump.engine.model import with_numbers
from snapjump.engine.shadow import Shadow, view_shadow
from snapjump.frame.base import contact_point, contact_points, frame_dofs
from snapjump.linear_solver.more_sides import FOUR
from snapjump.number.array import uncounted
from snapjump.number.dispatch import kernel, routine
from snapjump.number.dual import PARAMETERS, constant, dual, slope_at, slopes_of, value_of
from snapjump.number.functions import any_true, where
from snapjump.number.lane import view_numbers
from snapjump.recorder.base import (
    record_end,
    record_robot,
    record_stage,
    record_start,
    record_step,
)

Array = NDArray[np.float64]


FAR = 1.0e30  # no contact near to being made or broken


class SensitivityRecorder(NamedTuple):
    """Of R robots in W lanes.

    memory: of the march; shadow: of its lanes; numbers (R, P, 4): derivatives of the model's
    numbers; starts (R, 3, D, 4): of state, velocity and acceleration at the beginning; flights
    (R, 4, 4): of x, y, vx, vy of the centre of mass at the end; grazes (R): the change of one
    parameter (their slopes taken as they are) that would make or break a contact; falling (W, C):
    1 for points that came down in the last step; nearest (W): of grazes so far; chosen (W): lanes
    at hand; corrections (1): of a stage's derivatives.
    """

    memory: Any
    shadow: Shadow
    numbers: Array
    starts: Array
    flights: Array
    grazes: Array
    falling: Array
    nearest: Array
    chosen: NDArray[np.int64]
    corrections: NDArray[np.int64]


@kernel
def marked(recorder: Any, work: Any, mask: Any) -> int:
    """Put the masked lanes into ``chosen``; returns how many there are."""
    work.clock[MARK] = where(mask, 1.0, 0.0)
    count = 0
    for lane in range(recorder.chosen.shape[0]):
        if recorder.memory.clock[MARK, lane] > 0.0:
            recorder.chosen[count] = lane
            count += 1
    return count


@record_robot.member(SensitivityRecorder)
def _record_robot(recorder: SensitivityRecorder, lane: Any, robot: Any) -> None:
    memory = recorder.memory
    work = view_shadow(recorder.shadow, lane, memory.mesh)
    numbers = view_numbers(recorder.numbers[robot], FOUR)
    starts = view_numbers(recorder.starts[robot], FOUR)
    for k in range(work.numbers.shape[0]):
        work.numbers[k] = dual(memory.numbers[k, lane], numbers[k])
    for i in range(work.state.shape[0]):
        work.start[i] = dual(memory.start[i, lane], starts[0, i])
        for slot in range(work.velocity.shape[0]):
            work.velocity[slot, i] = dual(memory.velocity[slot, i, lane], starts[1, i])
            work.acceleration[slot, i] = dual(memory.acceleration[slot, i, lane], starts[2, i])
    recorder.nearest[lane] = FAR
    for point in range(recorder.falling.shape[1]):
        recorder.falling[lane, point] = 0.0


@record_start.member(SensitivityRecorder)
def _record_start(recorder: SensitivityRecorder, model: Any, masses: Any, work: Any) -> None:
    pass


@record_stage.member(SensitivityRecorder)
def _record_stage(
    recorder: SensitivityRecorder,
    model: Any,
    masses: Any,
    motion: Any,
    scheme: Any,
    work: Any,
    converged: Any,
) -> None:
    count = marked(recorder, work, converged)
    differentiate_stages(
        model,
        scheme,
        masses,
        uncounted(recorder.memory),
        uncounted(recorder.shadow),
        uncounted(recorder.chosen),
        count,
        recorder.corrections[0],
    )


@kernel
def graze(falling: Any, point: Any, gap: Any, rise: Any, reach: Any, nearest: Any) -> Any:
    """How near the lowest place of a point was to touching: in parameters, by the gap's slopes.

    The least of that and ``nearest``.
    """
    if rise < 0.0:
        falling[point] = 1.0
    elif falling[point] > 0.0:
        falling[point] = 0.0
        slopes = slopes_of(gap)
        steepest = 1e-300
        for k in range(PARAMETERS):
            steepest = max(steepest, abs(slope_at(slopes, k)))
        nearest = min(nearest, abs(value_of(gap) - reach) / steepest)
    return nearest


@routine
def look_for_grazes(
    recorder: Any, memory: Any, shadow: Any, template: Any, masses: Any, lane: Any
) -> None:
    """Judge every point of a lane that has stopped falling in the step that was committed."""
    mesh = memory.mesh
    work = view_shadow(shadow, lane, mesh)
    model = with_numbers(template, work.numbers)
    reach = value_of(contact_reach(model.contact) + constant(0.0))
    corners = contact_points(model.frame, mesh)
    falling = uncounted(recorder.falling[lane])
    nearest = recorder.nearest[lane]
    for point in range(corners):
        _, gap, _, rise = contact_point(model.frame, mesh, point, work.start, work.velocity[0])
        nearest = graze(falling, point, gap, value_of(rise), reach, nearest)
    for node in range(masses.shape[0]):
        if masses[node] > 0.0:
            i = node_dofs(model.discretization) * node + frame_dofs(model.frame, mesh) + 1
            rise = memory.velocity[0, i, lane]
            nearest = graze(falling, corners + node, work.start[i], rise, reach, nearest)
    recorder.nearest[lane] = nearest


@record_step.member(SensitivityRecorder)
def _record_step(
    recorder: SensitivityRecorder, model: Any, masses: Any, scheme: Any, work: Any, good: Any
) -> None:
    if any_true(good):
        memory = uncounted(recorder.memory)
        shadow = uncounted(recorder.shadow)
        for c in range(marked(recorder, work, good)):
            commit(scheme, memory, shadow, recorder.chosen[c])
            look_for_grazes(recorder, memory, shadow, model, masses, recorder.chosen[c])


@record_end.member(SensitivityRecorder)
def _record_end(
    recorder: SensitivityRecorder, model: Any, masses: Any, lane: Any, robot: Any
) -> None:
    mesh = recorder.memory.mesh
    work = view_shadow(recorder.shadow, lane, mesh)
    shadow = with_numbers(model, work.numbers)
    flight = view_numbers(recorder.flights[robot], FOUR)
    x, y, vx, vy = centre_of_mass(shadow, masses, mesh, work.start, work.velocity[0])
    flight[0] = slopes_of(x)
    flight[1] = slopes_of(y)
    flight[2] = slopes_of(vx)
    flight[3] = slopes_of(vy)
    recorder.grazes[robot] = recorder.nearest[lane]
