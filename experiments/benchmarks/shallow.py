"""The shallow arch: its fold in closed form, and the amplitude equation of the motion close to it.

Heights are sqrt(epsilon) W(s) in L, angles sqrt(epsilon) mu, times in T:

    W'''' + P W'' = -W_tt - nu W_t,

the integral of W'^2 / 2 is 1, W vanishes at both ends, W'(0) = -left, W'(1) = right. Along the
branch the thrust P grows, and still does where mu turns back: there phi = dW/dP is the mode in
which the arch gives way. Multiplied by it and integrated, the equation of second order for
W = W0 + A phi is

    A_tt + nu A_t = c1 (mu - mu_fold) + c2 A^2,

c1 = -(turned_left phi''(0) + turned_right phi''(1)) / <phi^2>, c2 = 3 <phi'^2> / (2 <phi^2>), of
which only the product matters to times and delays. Where the clamps keep their angles and the span
opens, the integral of W'^2 / 2 falls: it is 1 at the fold, and c1 = 1 / <phi^2> of its distance
from that, with the same phi and c2 (derived here; Gomez, Moulton and Vella 2017 and Liu, Gomez and
Vella 2021 have such an equation for their drives).
"""

import math
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from snapjump.arrays import Array

# Thrusts (EI/L^2) between which branches that begin at flat clamps have their folds: from Euler's
# load of the clamped beam; an odd shape needs no clamp to turn at the second, where others end.
FIRST, SECOND = 4.0 * math.pi**2, 80.7629
LAST = 120.0
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(40)
PLACES, WEIGHTS = 0.5 * (POINTS + 1.0), 0.5 * WEIGHTS
DIFFERENCE = 1e-3  # of the thrust


class Drive(NamedTuple):
    """How clamps turn: slopes at rest are ``fixed``, and grow by ``turned`` times mu (left,
    right)."""

    turned: tuple[float, float]
    fixed: tuple[float, float] = (0.0, 0.0)


ONE_END = Drive((1.0, 0.0))
ALIKE = Drive((1.0, 1.0))


def lagging(mismatch: float) -> Drive:
    """Both turn, the right one behind by so much (over sqrt(epsilon))."""
    return Drive((1.0, 1.0), (0.0, -mismatch))


class Fold(NamedTuple):
    """``mu``: angle over sqrt(epsilon); ``thrust`` (EI/L^2); ``product``: c1 c2 (1/T^4) of mu;
    ``opening``: of what epsilon is less than the fold's, over that."""

    mu: float
    thrust: float
    product: float
    opening: float


def coefficients(thrust: float, left: float, right: float) -> Array:
    """Of 1, s, cos(tau s), sin(tau s) in a shape with these slopes' angles, tau^2 the thrust."""
    tau = math.sqrt(thrust)
    c, s = math.cos(tau), math.sin(tau)
    conditions = [[1, 0, 1, 0], [1, 1, c, s], [0, 1, 0, tau], [0, 1, -tau * s, tau * c]]
    return np.linalg.solve(np.array(conditions), [0.0, 0.0, -left, right])


def derivative(thrust: float, shape: Array, order: int, places: Array) -> Array:
    """Of a shape at places in [0, 1]."""
    tau = math.sqrt(thrust)
    turn = 0.5 * math.pi * order
    waves = shape[2] * np.cos(tau * places + turn) + shape[3] * np.sin(tau * places + turn)
    line = (shape[0] + shape[1] * places, shape[1] + 0.0 * places, 0.0, 0.0)[min(order, 3)]
    return np.asarray(tau**order * waves + line)


def angle(thrust: float, drive: Drive) -> float:
    """mu of the branch's point with a thrust."""
    turned, fixed = (
        derivative(thrust, coefficients(thrust, *slopes), 1, PLACES)
        for slopes in (drive.turned, drive.fixed)
    )
    a, b, c = (0.5 * WEIGHTS @ (one * other) for one, other in
               ((turned, turned), (turned, fixed), (fixed, fixed)))  # fmt: skip
    return float((-b + math.sqrt(b * b - a * (c - 1.0))) / a)


def shape_of(thrust: float, drive: Drive) -> Array:
    """Coefficients of that point."""
    mu = angle(thrust, drive)
    left, right = (mu * t + f for t, f in zip(drive.turned, drive.fixed, strict=True))
    return coefficients(thrust, left, right)


def fold(drive: Drive) -> Fold:
    """The largest angle on the branch that begins at flat clamps, or at those of its mismatch."""
    last = LAST if drive.turned[0] == drive.turned[1] and drive.fixed == (0.0, 0.0) else SECOND
    found = minimize_scalar(
        lambda thrust: -angle(thrust, drive), bounds=(FIRST + 1e-3, last - 1e-3),
        method="bounded", options={"xatol": 1e-9},
    )  # fmt: skip
    thrust = float(found.x)
    places = np.array([0.0, 1.0])

    def mode(order: int, at: Array) -> Array:
        ahead, behind = (
            derivative(p, shape_of(p, drive), order, at)
            for p in (thrust + DIFFERENCE, thrust - DIFFERENCE)
        )
        return (ahead - behind) / (2.0 * DIFFERENCE)

    size, bent = WEIGHTS @ mode(0, PLACES) ** 2, WEIGHTS @ mode(1, PLACES) ** 2
    pushed = -float(np.array(drive.turned) @ mode(2, places)) / size
    second = 1.5 * bent / size
    return Fold(-float(found.fun), thrust, float(pushed * second), float(second / size))


def pitchfork() -> Fold:
    """Where the arch whose clamps turn alike may lean to a side: before its fold."""
    return Fold(angle(SECOND, ALIKE), SECOND, math.nan, math.nan)
