"""The largest bending of every robot's beam, with place and time, over its start and all steps."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.bending import fill_turnings
from snapjump.engine.clock import TIME
from snapjump.engine.recorder.running import Running, RunningRecorder, figures_of
from snapjump.frame.base import Rotations
from snapjump.number.dispatch import routine
from snapjump.number.functions import absolute, any_true, where
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros

# The largest turning at a node over an element's length, at which node, and when (T).
TURNING, NODE, WHEN = range(3)
FIGURES = 3


@RunningRecorder.member
class StrainRecorder(NamedTuple):
    """``running``: the figures; ``turnings`` (N + 1, W): of the state at hand."""

    running: Running
    turnings: NDArray[np.float64]

    def watches(self) -> bool:
        return False

    def record_beginning(self, model: Any, masses: Any, work: Any, begins: Any) -> None:
        look(self, model, work.mesh, work.clock[TIME], work.start, begins)

    def follow(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, course: Any, good: Any
    ) -> None:
        if any_true(good):
            look(self, model, work.mesh, work.clock[TIME], work.state, good)


def make_strain_recorder(running: Running, nodes: int) -> StrainRecorder:
    """A recorder of chains with so many nodes; ``running``: FIGURES of them."""
    return StrainRecorder(running, aligned_zeros((nodes, len(running.lanes))))


@routine
def look(recorder: Any, model: Any, mesh: Any, time: Any, state: Any, mask: Any) -> None:
    """See whether states of the masked lanes are bent more than any before."""
    still = Rotations(0.0 * time, 0.0 * time)
    angles = model.clamp.angles(time)
    tangents = model.frame.end_tangents(mesh, model.load, angles, state, still)
    turnings = view_numbers(recorder.turnings, recorder.running.lanes)
    fill_turnings(model.discretization, state[model.frame.dofs(mesh) :], tangents, turnings)
    figures = figures_of(recorder.running)
    largest = figures[TURNING]
    node = figures[NODE]
    when = figures[WHEN]
    for k in range(turnings.shape[0]):
        bent = absolute(turnings[k])
        more = mask & (bent > largest)
        largest = where(more, bent, largest)
        node = where(more, 1.0 * k, node)
        when = where(more, time, when)
    figures[TURNING] = largest
    figures[NODE] = node
    figures[WHEN] = when
