"""The largest normal force of the ground on every robot, over its start and all steps."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import TIME
from snapjump.engine.points import ground_force
from snapjump.engine.recorder.base import Recorder
from snapjump.engine.recorder.running import (
    Running,
    about_to_begin,
    figures_of,
    forget,
    keep,
    make_running,
)
from snapjump.number.dispatch import routine
from snapjump.number.functions import any_true, maximum, where

FORCE = 0  # of all points together, at most (EI/L^2)
FIGURES = 1


@Recorder.member
class GroundRecorder(NamedTuple):
    """``running``: the figure."""

    running: Running

    def record_robot(self, lane: Any, robot: Any) -> None:
        forget(self.running, lane)

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        begins = about_to_begin(work, converged)
        if any_true(begins):
            look(self, model, masses, work, begins)

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        look(self, model, masses, work, good)

    def record_end(self, model: Any, masses: Any, lane: Any, robot: Any) -> None:
        keep(self.running, lane, robot)


def make_ground_recorder(lanes: int, kept: NDArray[np.float64], nodes: int) -> GroundRecorder:
    """A recorder; ``kept`` (R, FIGURES)."""
    return GroundRecorder(make_running(lanes, kept))


@routine
def look(recorder: Any, model: Any, masses: Any, work: Any, mask: Any) -> None:
    """See whether the ground bears more at the masked lanes' beginnings of steps than before."""
    if model.contact.is_constraint():
        return  # its force is none of a state's
    figures = figures_of(recorder.running)
    still = Motion(work.clock[TIME], 0.0 * work.clock[TIME], 0.0 * work.clock[TIME], 0.0)
    force = ground_force(model, still, masses, work, work.start, work.velocity[0])
    figures[FORCE] = where(mask, maximum(figures[FORCE], force), figures[FORCE])
