"""The largest normal force of the ground on every robot, over its start and all steps."""

from typing import Any, NamedTuple

from snapjump.engine.assemble import Motion
from snapjump.engine.clock import TIME
from snapjump.engine.points import ground_force
from snapjump.engine.recorder.running import Running, RunningRecorder, figures_of
from snapjump.number.dispatch import routine
from snapjump.number.functions import maximum, where

FORCE = 0  # of all points together, at most (EI/L^2)
FIGURES = 1


@RunningRecorder.member
class GroundRecorder(NamedTuple):
    """``running``: the figure."""

    running: Running

    def record_beginning(self, model: Any, masses: Any, work: Any, begins: Any) -> None:
        look(self, model, masses, work, begins)

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        look(self, model, masses, work, good)


@routine
def look(recorder: Any, model: Any, masses: Any, work: Any, mask: Any) -> None:
    """See whether the ground bears more at the masked lanes' beginnings of steps than before."""
    if model.contact.is_constraint():
        return  # its force is none of a state's
    figures = figures_of(recorder.running)
    still = Motion(work.clock[TIME], 0.0 * work.clock[TIME], 0.0 * work.clock[TIME], 0.0)
    force = ground_force(model, still, masses, work, work.start, work.velocity[0])
    figures[FORCE] = where(mask, maximum(figures[FORCE], force), figures[FORCE])
