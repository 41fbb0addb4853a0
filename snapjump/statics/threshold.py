"""The symmetrically rotated arch's critical angle and depth, quickly: what every jump needs.

On the symmetric branch the clamp angle, the stiffness against the asymmetric mode and the nodes'
places are analytic in the height of the midpoint (in the angle they are not: the branch's fold is
only a percent away). So they are taken a few percent below the pitchfork, where everything is
well conditioned, and extrapolated to a vanishing stiffness.
:func:`snapjump.statics.critical.find_snap` walks the branch itself (compared in tests/statics).
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from snapjump.options.discretization import DiscretizationOptions
from snapjump.parameters.robot import Robot
from snapjump.statics.arch import StaticArch
from snapjump.statics.lowest_point import lowest_height

Array = NDArray[np.float64]

APPROACH_STEPS = 10
MOST_DEVIATION = 0.4  # of the critical angle from its estimate
# Shares of the angle guessed so far, in rounds that come nearer.
ROUNDS = ((0.80, 0.84, 0.88), (0.90, 0.93, 0.95, 0.965), (0.97, 0.98, 0.987, 0.992, 0.996, 0.998))


@dataclass(frozen=True)
class Threshold:
    """Critical angle (rad), and depth of the lowest point below the mounts there (in L)."""

    alpha_rad: float
    h1_bar: float


def extrapolated(places: Array, values: Array, place: float) -> Array:
    """The polynomial through values (n, ...) at so many places, at another one."""
    weights = [
        np.prod([(place - other) / (here - other) for other in places if other != here])
        for here in places
    ]
    return np.tensordot(weights, values, 1)


@lru_cache(maxsize=65536)
def symmetric_threshold(
    robot: Robot, discretization: DiscretizationOptions, epsilon: float
) -> Threshold:
    """Threshold of the arch whose clamps turn alike; computed once for each argument.

    Its depth is the optimal mount height, its angle the scale that a jump's start is a share of.
    Raises ArithmeticError where no equilibrium is found.
    """
    arch = StaticArch(robot, discretization, epsilon)
    # Shallow arches snap at 2 sqrt(epsilon); the next term is a fit of the elastica's values.
    estimate = np.sqrt(epsilon) * (2.0 + 0.193 * epsilon)
    state = arch.settle(arch.guess(), 0.0, 0.0)
    history = [state]
    for k in range(1, APPROACH_STEPS + 1):
        if len(history) > 2:
            state = 3.0 * history[-1] - 3.0 * history[-2] + history[-3]
        angle = 0.8 * estimate * k / APPROACH_STEPS
        state = arch.settle(state, angle, angle)
        history.append(state)

    nodes = len(arch.masses)
    guess = float(estimate)
    for shares in ROUNDS:
        angles = np.array(shares) * guess
        states, stiffnesses = [], []
        for angle in angles:
            state = arch.settle(state, angle, angle)
            states.append(state)
            stiffnesses.append(arch.asymmetric_stiffness())
        heights = np.array(states)[:, 1 :: arch.node_dofs]
        middles = 0.5 * (heights[:, (nodes - 1) // 2] + heights[:, nodes // 2])
        critical = float(extrapolated(np.array(stiffnesses), middles, 0.0))
        guess = float(extrapolated(middles, angles, critical))
        # Too shallow an arch, or too coarse a mesh for it: the branch is not one that snaps.
        if not abs(guess - estimate) < MOST_DEVIATION * estimate:
            raise ArithmeticError(f"no critical angle near {estimate:g} rad")
    return Threshold(guess, -lowest_height(extrapolated(middles, heights, critical)))
