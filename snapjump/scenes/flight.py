"""The flight of a robot that has left the ground: lift-off and apex from a march's outcome."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.engine import outcome as c
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.status import OK

Array = NDArray[np.float64]


class Flight(NamedTuple):
    """Apex and lift-off of the centre of mass, all dimensionless (L, T), of one jump or of many.

    Times count from the beginning of the clamps' rotation. Lift-off is the end of the last
    contact; place and velocity then follow from the parabola on which the march has ended. Where
    that is back at the height of lift-off the robot lands.
    """

    apex_x: Array
    apex_y: Array
    apex_time: Array
    liftoff_x: Array
    liftoff_y: Array
    liftoff_vx: Array
    liftoff_vy: Array
    liftoff_time: Array
    landing_x: Array


def flight(begun: Any, load: Gravity, outcome: Array) -> Flight:
    """The flight of outcomes (..., COLUMNS) of marches that began at times ``begun`` (T) of the
    rotation. The apex is the highest point against gravity.

    Whatever has not jumped has its apex where it is.
    """
    x, y = outcome[..., c.COM_X], outcome[..., c.COM_Y]
    vx, vy = outcome[..., c.COM_VX], outcome[..., c.COM_VY]
    time, fall, tug = outcome[..., c.TIME], load.gravity(), load.pull()
    rise = np.where(outcome[..., c.STATUS] == OK, np.maximum(load.rise(vx, vy), 0.0), 0.0)
    ahead = rise / load.acceleration
    aloft = time - outcome[..., c.LAST_CONTACT]
    away_x, away_vx = x - (vx - 0.5 * tug * aloft) * aloft, vx - tug * aloft
    airtime = 2.0 * np.maximum(vy + fall * aloft, 0.0) / fall
    return Flight(
        x + (vx + 0.5 * load.downhill * rise) * ahead,
        y + (vy - 0.5 * load.cosine * rise) * ahead,
        begun + time + ahead,
        away_x,
        y - (vy + 0.5 * fall * aloft) * aloft,
        away_vx,
        vy + fall * aloft,
        begun + outcome[..., c.LAST_CONTACT],
        away_x + (away_vx + 0.5 * tug * airtime) * airtime,
    )


def world(load: Gravity, x: Any, y: Any) -> tuple[Any, Any]:
    """Places along and across the ground as level and plumb ones."""
    return x * load.cosine + y * load.downhill, y * load.cosine - x * load.downhill
