"""What every robot's clamps must give: largest torque and power over its start and all steps, and
work, by the quadrature of the integrator itself."""

from typing import Any, NamedTuple

from snapjump.engine.clock import STAGE, STEP, TIME
from snapjump.engine.powers import held_beam
from snapjump.engine.recorder.running import Running, RunningRecorder, about_to_begin, figures_of
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, any_true, maximum, where

(
    TORQUE,  # of either clamp, either way, at most (EI/L)
    POWER,  # of both clamps together, at most (EI/(L T))
    WORK,  # of both clamps so far (EI/L)
    PENDING,  # work of the step under way
    POWER_AT_START,  # of that step
    POWER_NOW,  # at the last stage that has converged
    TORQUE_NOW,
) = range(7)
FIGURES = 7


@RunningRecorder.member
class ClampRecorder(NamedTuple):
    """``running``: the figures."""

    running: Running

    def record_beginning(self, model: Any, masses: Any, work: Any, begins: Any) -> None:
        figures = figures_of(self.running)
        look(figures, model, work.mesh, work.clock[TIME], work.start, work.velocity[0], begins)
        for to, read in ((POWER_AT_START, POWER_NOW), (POWER, POWER_NOW), (TORQUE, TORQUE_NOW)):
            figures[to] = where(begins, figures[read], figures[to])

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        figures = figures_of(self.running)
        stage, step = work.clock[STAGE], work.clock[STEP]
        begins = about_to_begin(work, converged)
        if any_true(begins):
            self.record_beginning(model, masses, work, begins)
        for k in range(1, scheme.stage_count() + 1):
            here = converged & (stage == 1.0 * k)
            if any_true(here):
                look(figures, model, work.mesh, motion.time, work.state, work.velocity[k], here)
                if k == 1:
                    first = step * scheme.quadrature_weight(0) * figures[POWER_AT_START]
                    figures[PENDING] = where(here, first, figures[PENDING])
                gained = step * scheme.quadrature_weight(k) * figures[POWER_NOW]
                figures[PENDING] = figures[PENDING] + where(here, gained, 0.0)

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        figures = figures_of(self.running)
        figures[WORK] = figures[WORK] + where(good, figures[PENDING], 0.0)
        figures[POWER_AT_START] = where(good, figures[POWER_NOW], figures[POWER_AT_START])
        if not scheme.ends_in_a_stage():
            look(figures, model, work.mesh, work.clock[TIME], work.start, work.velocity[0], good)
        rise_to(figures, good)


@routine
def look(
    figures: Any, model: Any, mesh: Any, time: Any, state: Any, velocity: Any, mask: Any
) -> None:
    """Read torque and power off states of the masked lanes."""
    held = held_beam(model, mesh, model.clamp.angles(time), state, velocity)
    torque = maximum(absolute(held.left), absolute(held.right))
    figures[TORQUE_NOW] = where(mask, torque, figures[TORQUE_NOW])
    figures[POWER_NOW] = where(mask, held.power, figures[POWER_NOW])


@kernel
def rise_to(figures: Any, mask: Any) -> None:
    """Let what was read off the masked lanes' states count."""
    for most, now in ((TORQUE, TORQUE_NOW), (POWER, POWER_NOW)):
        figures[most] = where(mask, maximum(figures[most], figures[now]), figures[most])
