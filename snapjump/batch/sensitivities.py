"""Derivatives of apexes by inputs, from those of the flights that a march has recorded."""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array, Flags
from snapjump.engine import outcome as c
from snapjump.engine.status import NO_JUMP, OK
from snapjump.scenes.flight import flight
from snapjump.scenes.sensitivities import SMALLEST_STICK_ZONE

# A change of a parameter that makes or breaks a contact: nearer than this, on one side only are
# the derivatives those of the map.
NEAREST = 1e-5
MOVING = [c.COM_VX, c.COM_VY]
# Of flights with drag: shares by which velocity, gravity or drag change, and the deceleration over
# the speed squared (1/L) below which they are shares of that.
DIFFERENCE, SMALLEST_DRAG = 1e-4, 1e-3


@dataclass(frozen=True)
class Sensitivities:
    """Derivatives of R apexes by I inputs.

    dx_bar, dy_bar (R, I): of x_bar and y_bar (L over the input's unit), NaN where there is no
    apex; they are those of the discrete steps, whose sizes (in the robot's own time) are frozen.
    graze_distance (R): how far an input must change, all gaps moving at their present slopes,
    to make or break one of the contacts; differentiable (R): whether it is more than 1e-5, and
    steps resolve friction's stick zone: else the errors of steps have slopes of their own, and
    derivatives are not those of the map.
    """

    dx_bar: Array
    dy_bar: Array
    graze_distance: Array
    differentiable: Flags


class Slopes(NamedTuple):
    """Of M marched robots: ``flights`` (M, 4, I), of x, y, vx, vy of the centre of mass at the end;
    ``load`` (M, 4, I), of the numbers of gravity, and ``drag`` (M, N, I), of those of the drag law;
    the distances of ``grazes`` (M)."""

    flights: Array
    load: Array
    drag: Array
    grazes: Array


def apex_sensitivities(
    outcome: Array, load: Any, drag: Any, slopes: Slopes, stick_zones: Any
) -> Sensitivities:
    """Sensitivities from outcomes (R, COLUMNS), gravity and drag, arrays (R), and half widths (R)
    of stick zones (L/T)."""
    status = outcome[:, c.STATUS]
    if drag.exists():
        dx, dy = through_air(outcome, load, drag, slopes)
    else:
        dx, dy = in_vacuum(outcome, load, slopes)
    known = np.isin(status, (OK, NO_JUMP))
    return Sensitivities(
        dx_bar=np.where(known[:, None], dx, np.nan),
        dy_bar=np.where(known[:, None], dy, np.nan),
        graze_distance=np.where(known, slopes.grazes, np.nan),
        differentiable=known & (slopes.grazes > NEAREST) & (stick_zones >= SMALLEST_STICK_ZONE),
    )


def in_vacuum(outcome: Array, load: Any, slopes: Slopes) -> tuple[Array, Array]:
    """Derivatives (R, I) of the apexes of parabolas."""
    load = load._make(numbers[:, None] for numbers in load)
    flew = (outcome[:, c.STATUS] == OK)[:, None]
    vx, vy = outcome[:, c.COM_VX, None], outcome[:, c.COM_VY, None]
    rise = np.where(flew, np.maximum(load.rise(vx, vy), 0.0), 0.0)
    ahead = rise / load.acceleration
    dx, dy, dvx, dvy = (slopes.flights[:, k] for k in range(4))
    stronger, cosine, downhill, _ = (slopes.load[:, k] for k in range(4))
    faster = load.rise(dvx, dvy) + vy * cosine - vx * downhill
    longer = np.where(rise > 0.0, (faster - ahead * stronger) / load.acceleration, 0.0)
    # The apex is at x + (vx + downhill rise / 2) ahead, y + (vy - cosine rise / 2) ahead.
    along = dvx + 0.5 * (downhill * rise + load.downhill * faster)
    across = dvy - 0.5 * (cosine * rise + load.cosine * faster)
    return (
        dx + along * ahead + (vx + 0.5 * load.downhill * rise) * longer,
        dy + across * ahead + (vy - 0.5 * load.cosine * rise) * longer,
    )


def through_air(outcome: Array, load: Any, drag: Any, slopes: Slopes) -> tuple[Array, Array]:
    """The same of flights with drag: central differences of them, which are smooth (1e-6)."""
    velocity = outcome[:, MOVING]
    numbers = np.column_stack([velocity, *load, *drag])
    rates = np.concatenate([slopes.flights[:, 2:], slopes.load, slopes.drag], axis=1)
    speed, fall = np.abs(velocity).sum(axis=1), load.acceleration
    of_drag = [np.maximum(np.abs(values), SMALLEST_DRAG) for values in drag]
    sizes = np.column_stack([speed, speed, *(fall for _ in load), *of_drag])
    found = slopes.flights[:, :2].copy()  # a flight from elsewhere ends as far away
    for i in range(found.shape[2]):
        way = rates[:, :, i]
        share = np.sum(np.abs(way) / np.maximum(sizes, 1e-100), axis=1, keepdims=True)
        step = DIFFERENCE / np.where(share > 0.0, share, 1.0)
        ends = [apexes(outcome, numbers + side * way, load, drag) for side in (step, -step)]
        found[:, :, i] += (ends[0] - ends[1]) / (2.0 * step)
    return found[:, 0], found[:, 1]


def apexes(outcome: Array, numbers: Array, load: Any, drag: Any) -> Array:
    """Apexes (R, 2) of outcomes with other velocities, gravity and drag: ``numbers`` (R, N)."""
    other, columns = outcome.copy(), numbers.T
    other[:, MOVING], first = numbers[:, :2], 2 + len(load)
    flown = flight(0.0, load._make(columns[2:first]), other, drag._make(columns[first:]))
    return np.column_stack([flown.apex_x, flown.apex_y])
