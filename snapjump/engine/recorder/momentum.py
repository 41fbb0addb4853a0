"""What every robot's momentum across the ground began with, and what drag has given it since."""

from typing import Any, NamedTuple

from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.clock import LAST_STEP
from snapjump.engine.recorder.running import Running, RunningRecorder, figures_of
from snapjump.number.dispatch import routine
from snapjump.number.functions import where

(
    HEIGHT,  # of the centre of mass at the start (L)
    RISE,  # its velocity across the ground there (L/T)
    AIR,  # velocity across the ground that drag has given it since
    AIR_NOW,  # acceleration by drag at the end of the last step (L/T^2)
) = range(4)
FIGURES = 4


@RunningRecorder.member
class MomentumRecorder(NamedTuple):
    """``running``: the figures."""

    running: Running

    def record_beginning(self, model: Any, masses: Any, work: Any, begins: Any) -> None:
        begin(self, model, masses, work, begins)

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        if model.drag.exists():
            add_air(self, model, masses, work, good)


@routine
def begin(recorder: Any, model: Any, masses: Any, work: Any, mask: Any) -> None:
    """Remember how the masked lanes' robots start."""
    figures = figures_of(recorder.running)
    _, y, vx, vy = centre_of_mass(model, masses, work.mesh, work.start, work.velocity[0])
    figures[HEIGHT] = where(mask, y, figures[HEIGHT])
    figures[RISE] = where(mask, vy, figures[RISE])
    if model.drag.exists():
        _, air = model.drag.acceleration(vx, vy)
        figures[AIR_NOW] = where(mask, air, figures[AIR_NOW])


@routine
def add_air(recorder: Any, model: Any, masses: Any, work: Any, mask: Any) -> None:
    """Add what drag has given in a step that is committed, by the trapezoidal rule."""
    figures = figures_of(recorder.running)
    _, _, vx, vy = centre_of_mass(model, masses, work.mesh, work.start, work.velocity[0])
    _, air = model.drag.acceleration(vx, vy)
    gained = 0.5 * work.clock[LAST_STEP] * (figures[AIR_NOW] + air)
    figures[AIR] = figures[AIR] + where(mask, gained, 0.0)
    figures[AIR_NOW] = where(mask, air, figures[AIR_NOW])
