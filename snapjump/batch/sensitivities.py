"""Derivatives of apexes by the design, from those of the flights that a march has recorded."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.engine import clock as c
from snapjump.engine.status import NO_JUMP, OK

Array = NDArray[np.float64]
# A change of a parameter that makes or breaks a contact: nearer than this, on one side only are
# the derivatives those of the map.
NEAREST = 1e-5


@dataclass(frozen=True)
class Sensitivities:
    """Derivatives of R apexes by (delta_alpha, epsilon, mass_bar, mu).

    dx_bar, dy_bar (R, 4): of x_bar and y_bar (1/rad for delta_alpha), NaN where there is no apex;
    they are those of the discrete steps, whose sizes are frozen.
    graze_distance (R): how far a parameter must change, all gaps moving at their present slopes,
    to make or break one of the contacts; differentiable (R): whether it is more than 1e-5.
    """

    dx_bar: Array
    dy_bar: Array
    graze_distance: Array
    differentiable: NDArray[np.bool_]


def apex_sensitivities(outcome: Array, fall: Array, flights: Array, grazes: Array) -> Sensitivities:
    """Sensitivities from outcomes (R, ROWS) and gravity (R) in L/T^2; flights (R, 4, 4): slopes of
    x, y, vx, vy of the centre of mass; grazes (R)."""
    status = outcome[:, c.STATUS]
    flew = status == OK
    rise = np.where(flew, np.maximum(outcome[:, c.COM_VY], 0.0), 0.0)[:, None]
    ahead = rise / fall[:, None]
    x, y, vx, vy = flights[:, 0], flights[:, 1], flights[:, 2], flights[:, 3]
    longer = np.where(flew[:, None], vy / fall[:, None], 0.0)
    known = np.isin(status, (OK, NO_JUMP))

    def of_known(values: Any) -> Array:
        return np.where(known[:, None], values, np.nan)

    return Sensitivities(
        dx_bar=of_known(x + vx * ahead + outcome[:, c.COM_VX, None] * longer),
        dy_bar=of_known(y + rise * longer),
        graze_distance=np.where(known, grazes, np.nan),
        differentiable=known & (grazes > NEAREST),
    )
