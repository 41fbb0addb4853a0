"""Derivatives of apexes by inputs, from those of the flights that a march has recorded."""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array, Flags
from snapjump.engine import outcome as c
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.status import NO_JUMP, OK

# A change of a parameter that makes or breaks a contact: nearer than this, on one side only are
# the derivatives those of the map.
NEAREST = 1e-5


@dataclass(frozen=True)
class Sensitivities:
    """Derivatives of R apexes by I inputs.

    dx_bar, dy_bar (R, I): of x_bar and y_bar (L over the input's unit), NaN where there is no
    apex; they are those of the discrete steps, whose sizes (in the robot's own time) are frozen.
    graze_distance (R): how far an input must change, all gaps moving at their present slopes,
    to make or break one of the contacts; differentiable (R): whether it is more than 1e-5.
    """

    dx_bar: Array
    dy_bar: Array
    graze_distance: Array
    differentiable: Flags


class Slopes(NamedTuple):
    """Of M marched robots: ``flights`` (M, 4, I), of x, y, vx, vy of the centre of mass at the end;
    ``load`` (M, 3, I), of gravity's acceleration, cosine and downhill; the distances of ``grazes``
    (M)."""

    flights: Array
    load: Array
    grazes: Array


def apex_sensitivities(outcome: Array, load: Gravity, slopes: Slopes) -> Sensitivities:
    """Sensitivities from outcomes (R, COLUMNS) and gravity, arrays (R, 1)."""
    status = outcome[:, c.STATUS]
    flew = (status == OK)[:, None]
    vx, vy = outcome[:, c.COM_VX, None], outcome[:, c.COM_VY, None]
    rise = np.where(flew, np.maximum(load.rise(vx, vy), 0.0), 0.0)
    ahead = rise / load.acceleration
    dx, dy, dvx, dvy = (slopes.flights[:, k] for k in range(4))
    stronger, cosine, downhill = (slopes.load[:, k] for k in range(3))
    faster = load.rise(dvx, dvy) + vy * cosine - vx * downhill
    longer = np.where(rise > 0.0, (faster - ahead * stronger) / load.acceleration, 0.0)
    # The apex is at x + (vx + downhill rise / 2) ahead, y + (vy - cosine rise / 2) ahead.
    along = dvx + 0.5 * (downhill * rise + load.downhill * faster)
    across = dvy - 0.5 * (cosine * rise + load.cosine * faster)
    known = np.isin(status, (OK, NO_JUMP))

    def of_known(values: Any) -> Array:
        return np.where(known[:, None], values, np.nan)

    return Sensitivities(
        dx_bar=of_known(dx + along * ahead + (vx + 0.5 * load.downhill * rise) * longer),
        dy_bar=of_known(dy + across * ahead + (vy - 0.5 * load.cosine * rise) * longer),
        graze_distance=np.where(known, slopes.grazes, np.nan),
        differentiable=known & (slopes.grazes > NEAREST),
    )
