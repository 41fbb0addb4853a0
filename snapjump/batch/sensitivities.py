"""Derivatives of apexes by inputs, from those of the flights that a march has recorded."""

from dataclasses import dataclass
from typing import Any, NamedTuple

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
    """Derivatives of R apexes by I inputs.

    dx_bar, dy_bar (R, I): of x_bar and y_bar (L over the input's unit), NaN where there is no
    apex; they are those of the discrete steps, whose sizes (in the robot's own time) are frozen.
    graze_distance (R): how far an input must change, all gaps moving at their present slopes,
    to make or break one of the contacts; differentiable (R): whether it is more than 1e-5.
    """

    dx_bar: Array
    dy_bar: Array
    graze_distance: Array
    differentiable: NDArray[np.bool_]


class Slopes(NamedTuple):
    """Of M marched robots: ``flights`` (M, 4, I), of x, y, vx, vy of the centre of mass at the end;
    ``fall`` (M, I), of gravity; and the distances of ``grazes`` (M)."""

    flights: Array
    fall: Array
    grazes: Array


def apex_sensitivities(outcome: Array, fall: Array, slopes: Slopes) -> Sensitivities:
    """Sensitivities from outcomes (R, ROWS) and gravity (R) in L/T^2; all rows are marched."""
    status = outcome[:, c.STATUS]
    flew = status == OK
    rise = np.where(flew, np.maximum(outcome[:, c.COM_VY], 0.0), 0.0)[:, None]
    ahead = rise / fall[:, None]
    x, y, vx, vy = (slopes.flights[:, k] for k in range(4))
    longer = np.where(flew[:, None], (vy - ahead * slopes.fall) / fall[:, None], 0.0)
    known = np.isin(status, (OK, NO_JUMP))

    def of_known(values: Any) -> Array:
        return np.where(known[:, None], values, np.nan)

    return Sensitivities(
        dx_bar=of_known(x + vx * ahead + outcome[:, c.COM_VX, None] * longer),
        dy_bar=of_known(y + rise * longer + 0.5 * ahead * ahead * slopes.fall),
        graze_distance=np.where(known, slopes.grazes, np.nan),
        differentiable=known & (slopes.grazes > NEAREST),
    )
