"""Termination of a jump that is followed to its apex: what the ballistic one is judged by."""

from typing import Any, NamedTuple

from snapjump.engine.centre_of_mass import centre_of_mass, mean_rotation
from snapjump.engine.clock import COM_VX, COM_VY, COM_X, COM_Y, GAP, SPIN, TIME
from snapjump.engine.status import OK, RUNNING, TIME_LIMIT
from snapjump.engine.termination.base import Termination
from snapjump.number.functions import where


@Termination.member
class ApexTermination(NamedTuple):
    """The last moment (T), and the height (L) from which a centre of mass that sinks has flown."""

    duration: float
    height: float

    def time_limit(self, model: Any) -> Any:
        return self.duration

    def tolerance_factor(self, model: Any, work: Any) -> float:
        return 1.0

    def terminate(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        clock = work.clock
        over = clock[TIME] >= self.duration * (1.0 - 1e-12)
        x, y, vx, vy = centre_of_mass(model, masses, work.mesh, work.start, work.velocity[0])
        clock[COM_X] = where(ended, x, clock[COM_X])
        clock[COM_Y] = where(ended, y, clock[COM_Y])
        clock[COM_VX] = where(ended, vx, clock[COM_VX])
        clock[COM_VY] = where(ended, vy, clock[COM_VY])
        sinking = (clock[GAP] >= model.ground.clearance) & (vy <= 0.0) & (y > self.height)
        status = where(over, 1.0 * TIME_LIMIT, 1.0 * RUNNING)
        about = x, y, vx, vy
        spin = mean_rotation(model, masses, work.mesh, work.start, work.velocity[0], about)
        clock[SPIN] = where(ended, spin, clock[SPIN])
        return where(sinking, 1.0 * OK, status)
