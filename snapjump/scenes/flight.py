"""The flight of a robot that has left the ground: lift-off and apex from a march's outcome."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.drag.none import NoDrag
from snapjump.engine import outcome as c
from snapjump.engine.flight import Arcs, Surroundings, fly
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.models import numbers_of_columns
from snapjump.engine.status import OK

Array = NDArray[np.float64]
VACUUM = NoDrag.Law()


class Flight(NamedTuple):
    """Apex and lift-off of the centre of mass, all dimensionless (L, T), of one jump or of many.

    Times count from the beginning of the clamps' rotation. Lift-off is the end of the last
    contact; place and velocity then follow from the flight on which the march has ended. Where
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


def flight(begun: Any, load: Gravity, outcome: Array, drag: Any = VACUUM) -> Flight:
    """The flight of outcomes (..., COLUMNS) of marches that began at times ``begun`` (T) of the
    rotation. The apex is the highest point against gravity.

    Whatever has not jumped has its apex where it is.
    """
    time = outcome[..., c.TIME]
    arcs = through_air(load, drag, outcome) if drag.exists() else parabola(load, outcome)
    return Flight(
        arcs.apex_x,
        arcs.apex_y,
        begun + time + arcs.ahead,
        *arcs[3:-1],
        begun + outcome[..., c.LAST_CONTACT],
        arcs.landing_x,
    )


def parabola(load: Gravity, outcome: Array) -> Arcs:
    """Flights in vacuum."""
    x, y = outcome[..., c.COM_X], outcome[..., c.COM_Y]
    vx, vy = outcome[..., c.COM_VX], outcome[..., c.COM_VY]
    time, fall, tug = outcome[..., c.TIME], load.gravity(), load.pull()
    rise = np.where(outcome[..., c.STATUS] == OK, np.maximum(load.rise(vx, vy), 0.0), 0.0)
    ahead = rise / load.acceleration
    aloft = time - outcome[..., c.LAST_CONTACT]
    away_x, away_vx = x - (vx - 0.5 * tug * aloft) * aloft, vx - tug * aloft
    airtime = 2.0 * np.maximum(vy + fall * aloft, 0.0) / fall
    return Arcs(
        x + (vx + 0.5 * load.downhill * rise) * ahead,
        y + (vy - 0.5 * load.cosine * rise) * ahead,
        ahead,
        away_x,
        y - (vy + 0.5 * fall * aloft) * aloft,
        away_vx,
        vy + fall * aloft,
        away_x + (away_vx + 0.5 * tug * airtime) * airtime,
    )


def through_air(load: Gravity, drag: Any, outcome: Array) -> Arcs:
    """Flights with drag."""
    rows = outcome.reshape(-1, outcome.shape[-1])
    around = Surroundings(load, drag)
    numbers = numbers_of_columns(around, len(rows))
    template = Surroundings(*(type(m)(*([0.0] * len(m))) for m in around))
    ends = np.ascontiguousarray(rows[:, [c.COM_X, c.COM_Y, c.COM_VX, c.COM_VY]])
    # What has not flown stays where it is: it has neither velocity nor time in the air.
    flew = rows[:, c.STATUS] == OK
    ends[~flew, 2:] = 0.0
    aloft = np.where(flew, rows[:, c.TIME] - rows[:, c.LAST_CONTACT], 0.0)
    arcs = Arcs(*(np.zeros(len(rows)) for _ in Arcs._fields))
    fly(template, numbers, ends, aloft, arcs)
    return Arcs(*(values.reshape(outcome.shape[:-1]) for values in arcs))


def world(load: Gravity, x: Any, y: Any) -> tuple[Any, Any]:
    """Places along and across the ground as level and plumb ones."""
    return x * load.cosine + y * load.downhill, y * load.cosine - x * load.downhill
