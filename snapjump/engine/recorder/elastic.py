"""Elastic energy of every robot at its start and at its last contact, and where it started."""

from typing import Any, NamedTuple

from snapjump.engine.centre_of_mass import mean_of
from snapjump.engine.clock import LAST_CONTACT, TIME
from snapjump.engine.read_out import elastic_energy
from snapjump.engine.recorder.running import Running, RunningRecorder, figures_of
from snapjump.frame.base import Rotations
from snapjump.number.dispatch import routine
from snapjump.number.functions import any_true, where

HEIGHT, START, LAST = range(3)  # of the centre of mass (L); energies (EI/L)
FIGURES = 3


@RunningRecorder.member
class ElasticRecorder(NamedTuple):
    """``running``: the figures."""

    running: Running

    def record_beginning(self, model: Any, masses: Any, work: Any, begins: Any) -> None:
        figures = figures_of(self.running)
        look(figures, model, work, begins)
        figures[START] = where(begins, figures[LAST], figures[START])
        _, y = mean_of(model, masses, work.mesh, work.start)
        figures[HEIGHT] = where(begins, y, figures[HEIGHT])

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        touching = good & (work.clock[LAST_CONTACT] == work.clock[TIME])
        if any_true(touching):
            look(figures_of(self.running), model, work, touching)


@routine
def look(figures: Any, model: Any, work: Any, mask: Any) -> None:
    """Read the energy off the beginnings of the masked lanes' steps."""
    time = work.clock[TIME]
    still = Rotations(0.0 * time, 0.0 * time)
    angles = model.clamp.angles(time)
    tangents = model.frame.end_tangents(work.mesh, model.load, angles, work.start, still)
    energy = elastic_energy(model, work.mesh, work.start, tangents)
    figures[LAST] = where(mask, energy, figures[LAST])
