"""Derivatives of where every robot's centre of mass flies, by four parameters.

The march itself is not touched: it takes the same steps with and without this recorder.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.clock import MARK
from snapjump.engine.differentiate import commit, differentiate_stages
from snapjump.engine.model import with_numbers
from snapjump.engine.points import point_at, point_count, share_of
from snapjump.engine.recorder.base import Recorder
from snapjump.engine.tangent import TangentState, view_tangent
from snapjump.engine.view import view_memory
from snapjump.linear_solver.right_hand_sides import FOUR
from snapjump.number.array import uncounted
from snapjump.number.dispatch import kernel, routine
from snapjump.number.dual import PARAMETERS, constant, dual, slope_at, slopes_of, value_of
from snapjump.number.functions import any_true, where
from snapjump.number.lane import view_numbers

Array = NDArray[np.float64]


FAR = 1.0e30  # no contact near to being made or broken


@Recorder.member
class SensitivityRecorder(NamedTuple):
    """Of R robots in W lanes.

    memory: of the march; tangent: of its lanes; numbers (R, P, 4): derivatives of the model's
    numbers; starts (R, 3, D, 4): of state, velocity and acceleration at the beginning; flights
    (R, 4, 4): of x, y, vx, vy of the centre of mass at the end; grazes (R): the change of one
    parameter (their slopes taken as they are) that would make or break a contact; falling (W, C):
    1 for points that came down in the last step; nearest (W): of grazes so far; chosen (W): lanes
    at hand; corrections (1): of a stage's derivatives.
    """

    memory: Any
    tangent: TangentState
    numbers: Array
    starts: Array
    flights: Array
    grazes: Array
    falling: Array
    nearest: Array
    chosen: NDArray[np.int64]
    corrections: NDArray[np.int64]

    def record_robot(self, lane: Any, robot: Any) -> None:
        memory = view_memory(self.memory)
        work = view_tangent(self.tangent, lane)
        numbers = view_numbers(self.numbers[robot], FOUR)
        starts = view_numbers(self.starts[robot], FOUR)
        for k in range(work.numbers.shape[0]):
            work.numbers[k] = dual(memory.numbers[k, lane], numbers[k])
        for i in range(work.state.shape[0]):
            work.start[i] = dual(memory.start[i, lane], starts[0, i])
            for slot in range(work.velocity.shape[0]):
                work.velocity[slot, i] = dual(memory.velocity[slot, i, lane], starts[1, i])
                work.acceleration[slot, i] = dual(memory.acceleration[slot, i, lane], starts[2, i])
        self.nearest[lane] = FAR
        for point in range(self.falling.shape[1]):
            self.falling[lane, point] = 0.0

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        count = marked(self, work, converged)
        differentiate_stages(
            model,
            scheme,
            masses,
            view_memory(self.memory),
            uncounted(self.tangent),
            uncounted(self.chosen),
            count,
            self.corrections[0],
        )

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        if any_true(good):
            memory = view_memory(self.memory)
            tangent = uncounted(self.tangent)
            for c in range(marked(self, work, good)):
                commit(scheme, memory, tangent, self.chosen[c])
                look_for_grazes(self, tangent, model, masses, self.chosen[c])

    def record_end(self, model: Any, masses: Any, lane: Any, robot: Any) -> None:
        work = view_tangent(self.tangent, lane)
        dual_model = with_numbers(model, work.numbers)
        flight = view_numbers(self.flights[robot], FOUR)
        x, y, vx, vy = centre_of_mass(dual_model, masses, work.mesh, work.start, work.velocity[0])
        flight[0] = slopes_of(x)
        flight[1] = slopes_of(y)
        flight[2] = slopes_of(vx)
        flight[3] = slopes_of(vy)
        self.grazes[robot] = self.nearest[lane]


@kernel
def marked(recorder: Any, work: Any, mask: Any) -> int:
    """Put the masked lanes into ``chosen``; returns how many there are."""
    work.clock[MARK] = where(mask, 1.0, 0.0)
    clock = view_memory(recorder.memory).clock
    count = 0
    for lane in range(recorder.chosen.shape[0]):
        if clock[MARK, lane] > 0.0:
            recorder.chosen[count] = lane
            count += 1
    return count


@kernel
def graze(falling: Any, point: Any, gap: Any, rise: Any, reach: Any, nearest: Any) -> Any:
    """How near the lowest place of a point was to touching: in parameters, by the slopes of its
    distance from there.

    The least of that and ``nearest``.
    """
    if rise < 0.0:
        falling[point] = 1.0
    elif falling[point] > 0.0:
        falling[point] = 0.0
        distance = gap - reach
        slopes = slopes_of(distance)
        steepest = 1e-300
        for k in range(PARAMETERS):
            steepest = max(steepest, abs(slope_at(slopes, k)))
        nearest = min(nearest, abs(value_of(distance)) / steepest)
    return nearest


@routine
def look_for_grazes(recorder: Any, tangent: Any, template: Any, masses: Any, lane: Any) -> None:
    """Judge every point of a lane that has stopped falling in the step that was committed."""
    work = view_tangent(tangent, lane)
    mesh = work.mesh
    model = with_numbers(template, work.numbers)
    reach = model.contact.reach() + constant(0.0)
    falling = uncounted(recorder.falling[lane])
    nearest = recorder.nearest[lane]
    for k in range(point_count(model, masses, mesh)):
        if any_true(share_of(template, masses, mesh, k) > 0.0):
            point = point_at(model, masses, mesh, k, work.start, work.velocity[0])
            nearest = graze(falling, k, point.gap, value_of(point.vy), reach, nearest)
    recorder.nearest[lane] = nearest
