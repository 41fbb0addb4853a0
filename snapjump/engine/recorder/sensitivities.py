"""Derivatives of where every robot's centre of mass flies, by four parameters.

The march itself is not touched: it takes the same steps with and without this recorder.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.clock import STAGE, STEP
from snapjump.engine.differentiate import (
    commit_slopes,
    differentiate_stage,
    end_slopes,
    keep_slopes,
)
from snapjump.engine.model import with_numbers
from snapjump.engine.points import point_at, point_count, share_of
from snapjump.engine.recorder.base import Recorder
from snapjump.engine.slopes import view_slopes
from snapjump.engine.stage import Course, Ended, rates_of
from snapjump.engine.tangent import TangentState, view_tangent
from snapjump.engine.view import view_work
from snapjump.number.array import uncounted
from snapjump.number.dispatch import kernel, routine
from snapjump.number.dual import slopes_of, steepest, value_of
from snapjump.number.dual_type import PARAMETERS
from snapjump.number.functions import absolute, any_true, maximum, minimum, negate, where
from snapjump.number.lane import view_numbers

Array = NDArray[np.float64]


FAR = 1.0e30  # no contact near to being made or broken


@Recorder.member
class SensitivityRecorder(NamedTuple):
    """Of R robots in W lanes.

    memory: of the march; lanes: a tuple of W; tangent: of its lanes; numbers (R, P, 4): derivatives
    of the model's numbers; starts (R, 3, D, 4): of state, velocity and acceleration at the
    beginning; flights (R, 4, 4): of x, y, vx, vy of the centre of mass at the end; grazes (R): the
    change of one parameter (their slopes taken as they are) that would make or break a contact;
    falling (C, W): 1 for points that came down in the last step; nearest (1, W): of grazes so far;
    most: corrections of a stage's derivatives, where the matrix is not exact.
    """

    memory: Any
    lanes: tuple[int, ...]
    tangent: TangentState
    numbers: Array
    starts: Array
    flights: Array
    grazes: Array
    falling: Array
    nearest: Array
    most: int

    def watches(self) -> bool:
        return False

    def record_robot(self, lane: Any, robot: Any) -> None:
        work = view_work(self.memory, self.lanes)
        slopes = view_slopes(work, uncounted(self.tangent))
        width = self.nearest.shape[1]
        numbers = uncounted(self.numbers)
        starts = uncounted(self.starts)
        for p in range(PARAMETERS):
            place = p * width + lane
            for k in range(slopes.numbers.shape[0]):
                slopes.numbers[k, place] = numbers[robot, k, p]
            for i in range(slopes.start.shape[0]):
                slopes.start[i, place] = starts[robot, 0, i, p]
                for slot in range(slopes.velocity.shape[0]):
                    slopes.velocity[slot, i, place] = starts[robot, 1, i, p]
                    slopes.acceleration[slot, i, place] = starts[robot, 2, i, p]
        self.nearest[0, lane] = FAR
        for point in range(self.falling.shape[0]):
            self.falling[point, lane] = 0.0

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        if not scheme.ends_in_a_stage():  # what is judged next moves the state on
            stage = work.clock[STAGE]
            step = Ended(work.clock[STEP], rates_of(motion))
            course = Course(stage, converged, step)
            twin = view_tangent(work, uncounted(self.tangent))
            of_duals = with_numbers(model, twin.numbers)
            last = scheme.stage_count()
            differentiate_stage(of_duals, scheme, masses, twin, motion, course, self.most)
            keep_slopes(scheme, twin, course, last)
            ended = converged & (stage >= 1.0 * last)
            if any_true(ended):
                end_slopes(of_duals, scheme, twin, course, ended)

    def follow(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, course: Any, good: Any
    ) -> None:
        twin = view_tangent(work, uncounted(self.tangent))
        of_duals = with_numbers(model, twin.numbers)
        if scheme.ends_in_a_stage():
            differentiate_stage(of_duals, scheme, masses, twin, motion, course, self.most)
            keep_slopes(scheme, twin, course, scheme.stage_count() - 1)
        if any_true(good):
            commit_slopes(scheme, twin, course, good)
            look_for_grazes(self, of_duals, masses, twin, good)

    def record_end(self, model: Any, masses: Any, lane: Any, robot: Any) -> None:
        work = view_work(self.memory, self.lanes)
        twin = view_tangent(work, uncounted(self.tangent))
        of_duals = with_numbers(model, twin.numbers)
        flight = centre_of_mass(of_duals, masses, twin.mesh, twin.start, twin.velocity[0])
        # From here they can be read lane by lane.
        sides = twin.bare_padded_residual
        first = HALF_BANDWIDTH
        for k in range(4):
            sides[first + k] = slopes_of(flight[k])
        slopes = view_slopes(work, uncounted(self.tangent)).padded_residual
        width = self.nearest.shape[1]
        for k in range(4):
            for p in range(PARAMETERS):
                self.flights[robot, k, p] = slopes[first + k, p * width + lane]
        self.grazes[robot] = self.nearest[0, lane]


@kernel
def nearer(gap: Any, reach: Any, nearest: Any) -> Any:
    """How near the lowest place of a point was to touching: in parameters, by the slopes of its
    distance from there. The least of that and ``nearest``."""
    distance = gap - reach
    slope = maximum(steepest(distance), 1e-300 + 0.0 * nearest)
    return minimum(absolute(value_of(distance)) / slope, nearest)


@routine
def look_for_grazes(recorder: Any, model: Any, masses: Any, twin: Any, good: Any) -> None:
    """Judge every point that has stopped falling in a step that stands, and is committed."""
    mesh = twin.mesh
    every = view_numbers(recorder.falling, recorder.lanes)
    least = view_numbers(recorder.nearest, recorder.lanes)
    for k in range(point_count(model, masses, mesh)):
        if any_true(share_of(model, masses, mesh, k) > 0.0):
            point = point_at(model, masses, mesh, k, twin.state, twin.velocity[0])
            before = point_at(model, masses, mesh, k, twin.start, twin.velocity[0])
            falls = value_of(point.gap) < value_of(before.gap)
            stopped = good & negate(falls) & (every[k] > 0.0)
            if any_true(stopped):
                nearest = least[0]
                found = nearer(point.gap, model.contact.reach(), nearest)
                least[0] = where(stopped, found, nearest)
            every[k] = where(good, where(falls, 1.0 + 0.0 * every[k], 0.0), every[k])
