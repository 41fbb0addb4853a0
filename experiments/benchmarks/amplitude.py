"""The amplitude equation near a fold: how late it blows up, with inertia alone and overdamped.

A_tt + nu A_t = c1 mu + c2 A^2, scaled so that one number is left of each problem.
"""

import math
from functools import cache

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ai_zeros, gamma

from .arches import DAMPING, DRAG, INERTIA

# Of the delay and of the time, by what resists: mu = rate t, and mu held.
DELAY_EXPONENTS = {INERTIA: 4.0 / 5.0, DAMPING: 2.0 / 3.0}
TIME_EXPONENTS = {INERTIA: -1.0 / 4.0, DAMPING: -1.0 / 2.0}
LONG_AGO, BLOWN_UP = -30.0, 1e6


@cache
def blow_up() -> float:
    """When the solution of y'' = t + y^2 that follows -sqrt(-t), without swinging about it, becomes
    infinite."""

    def arrived(t: float, y: np.ndarray) -> float:
        return float(y[0] - BLOWN_UP)

    arrived.terminal = True  # type: ignore[attr-defined]
    ago = -LONG_AGO
    start = [-math.sqrt(ago) - 0.125 / ago**2, 0.5 / math.sqrt(ago) - 0.25 / ago**3]
    found = solve_ivp(
        lambda t, y: [y[1], t + y[0] * y[0]], (LONG_AGO, 10.0), start, "DOP853", events=arrived,
        rtol=1e-11, atol=1e-11,
    )  # fmt: skip
    # From there on t is nothing beside y^2: what is left is the integral of dy / sqrt(2 y^3 / 3).
    return float(found.t_events[0][0]) + math.sqrt(6.0 / BLOWN_UP)


def delay_prefactor(regime: str, product: float) -> float:
    """Of the rate (1/T) to its power, in the delay of mu; product: c1 c2."""
    if regime == INERTIA:
        return float(blow_up() * product ** (-1.0 / 5.0))
    # The Riccati equation's solution is -Ai'(-t)/Ai(-t): it blows up at the first zero of Ai.
    return float(-ai_zeros(1)[0][0] * (DRAG * DRAG / product) ** (1.0 / 3.0))


def time_prefactor(regime: str, product: float) -> float:
    """Of the distance of mu from its fold to its power, in the time (T) from rest at A = 0."""
    if regime == INERTIA:
        # The integral of da / sqrt(2 a + 2 a^3 / 3) over all a > 0.
        whole = 0.5 * gamma(0.25) ** 2 / math.sqrt(math.pi) * 3.0**0.25 / math.sqrt(2.0)
        return float(whole * product ** (-1.0 / 4.0))
    return float(0.5 * math.pi * DRAG / math.sqrt(product))
