"""Euler's elastica between turned clamps as a boundary value problem, solved by collocation.

Nothing of it is shared with the library's kernels. Of a beam whose axis stretches by lam times its
tension (lam = EI/(EA L^2); 0: it does not), with the tangent's angle theta and curvature kappa over
the undeformed abscissa s in [0, 1], and the force (H, V) on its right end (EI/L^2):

    theta' = kappa, x' = g cos(theta), y' = g sin(theta), kappa' = g (H sin(theta) - V cos(theta)),
    g = 1 + lam (H cos(theta) + V sin(theta)),

theta = -left, x = y = 0 at s = 0, and theta = right, x = 1 - epsilon, y = 0 at s = 1. A branch is
followed by its thrust -H, which still grows where the angle turns back. At its fold the linearised
equations have a solution too: both are solved together, angle and thrust among the unknowns.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_bvp

from snapjump.arrays import Array

# Relative residuals: of folds, and of the branches that lead there.
TOLERANCE, COARSE, MOST_NODES = 1e-9, 1e-5, 20_000
NODES = 65  # of the first mesh
STEP, MOST_STEPS = 1.0, 200  # of the thrust (EI/L^2)
WAVE = 2.0 * np.pi  # of the arch that has just buckled


@dataclass(frozen=True)
class Clamps:
    """Pre-compression, how far the right clamp lags (rad), and lam."""

    epsilon: float
    delta_alpha: float
    stretch: float = 0.0


@dataclass(frozen=True)
class Elastica:
    """A solution: ``left`` (rad), abscissae (n), theta, kappa, x, y (4, n), and the force (H, V).
    ``residual``: the largest relative one that collocation leaves between its points."""

    left: float
    places: Array
    states: Array
    force: Array
    residual: float


def slopes(states: Any, force: Any, stretch: float) -> Any:
    """d(theta, kappa, x, y)/ds."""
    theta, kappa, _, _ = states
    c, s = np.cos(theta), np.sin(theta)
    g = 1.0 + stretch * (force[0] * c + force[1] * s)
    return np.vstack([kappa, g * (force[0] * s - force[1] * c), g * c, g * s])


def varied_slopes(states: Any, force: Any, change: Any, push: Any, stretch: float) -> Any:
    """The derivative of the same, along a change of states and of the force."""
    theta = states[0]
    c, s = np.cos(theta), np.sin(theta)
    along, across = force[0] * c + force[1] * s, force[0] * s - force[1] * c
    g = 1.0 + stretch * along
    turned = change[0]
    dg = stretch * (push[0] * c + push[1] * s - across * turned)
    dacross = push[0] * s - push[1] * c + along * turned
    return np.vstack(
        [change[1], dg * across + g * dacross, dg * c - g * s * turned, dg * s + g * c * turned]
    )


def ends(first: Array, last: Array, left: float, clamps: Clamps) -> list[float]:
    """What clamps hold, as numbers that vanish."""
    right, span = left - clamps.delta_alpha, 1.0 - clamps.epsilon
    return [first[0] + left, last[0] - right, first[2], first[3], last[2] - span, last[3]]


def solved(problem: Any) -> Any:
    """A solution of solve_bvp. Raises ArithmeticError where there is none."""
    if not problem.success:
        raise ArithmeticError(f"collocation: {problem.message}")
    return problem


def point(thrust: float, clamps: Clamps, guess: Elastica) -> Elastica:
    """The elastica with that thrust, near another one."""

    def equations(s: Any, states: Any, p: Any) -> Any:
        return slopes(states, (-thrust, p[0]), clamps.stretch)

    def conditions(first: Any, last: Any, p: Any) -> Any:
        return np.array(ends(first, last, p[1], clamps))

    found = solved(
        solve_bvp(equations, conditions, guess.places, guess.states, [guess.force[1], guess.left],
                  tol=COARSE, max_nodes=MOST_NODES)
    )  # fmt: skip
    force = np.array([-thrust, found.p[0]])
    return Elastica(float(found.p[1]), found.x, found.y, force, float(found.rms_residuals.max()))


def flat(epsilon: float) -> Elastica:
    """A first guess: the shallow arch between flat clamps, buckled up."""
    s = np.linspace(0.0, 1.0, NODES)
    rise = 2.0 * np.sqrt(epsilon)
    theta, kappa = rise * np.sin(WAVE * s), rise * WAVE * np.cos(WAVE * s)
    y = rise * (1.0 - np.cos(WAVE * s)) / WAVE
    states = np.vstack([theta, kappa, (1.0 - epsilon) * s, y])
    return Elastica(0.0, s, states, np.array([-(WAVE**2), 0.0]), np.inf)


def branch(clamps: Clamps) -> list[Elastica]:
    """From clamps near flat over the fold, to the first point behind it."""
    guess = flat(clamps.epsilon)
    points: list[Elastica] = []
    for k in range(1, MOST_STEPS):
        points.append(point(WAVE**2 + k * STEP, clamps, guess))
        guess = points[-1]
        if k > 2 and points[-1].left < points[-2].left:
            return points
    raise ArithmeticError(f"no fold up to a thrust of {WAVE**2 + MOST_STEPS * STEP:g} EI/L^2")


def fold(clamps: Clamps) -> Elastica:
    """The fold of the branch: the largest angle of the left clamp."""
    *_, before, near, behind = branch(clamps)
    s, thrust = near.places, before.force[0] - behind.force[0]
    change = (resampled(behind, s) - resampled(before, s)) / thrust
    push = (behind.force[1] - before.force[1]) / thrust

    def equations(s: Any, y: Any, p: Any) -> Any:
        own = slopes(y[:4], p[:2], clamps.stretch)
        return np.vstack([own, varied_slopes(y[:4], p[:2], y[4:], (-1.0, p[3]), clamps.stretch)])

    def conditions(first: Any, last: Any, p: Any) -> Any:
        held = [first[4], last[4], first[6], first[7], last[6], last[7]]
        return np.array([*ends(first[:4], last[:4], p[2], clamps), *held])

    found = solved(
        solve_bvp(equations, conditions, s, np.vstack([near.states, change]),
                  [*near.force, near.left, push], tol=TOLERANCE, max_nodes=MOST_NODES)
    )  # fmt: skip
    residual = float(found.rms_residuals.max())
    return Elastica(float(found.p[2]), found.x, found.y[:4], found.p[:2], residual)


def resampled(one: Elastica, places: Array) -> Array:
    """Its states at other abscissae."""
    return np.vstack([np.interp(places, one.places, row) for row in one.states])
