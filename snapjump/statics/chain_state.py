"""The nodes of a chain as a part of the state vector."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.number.dispatch import compiled
from snapjump.number.functions import sqrt
from snapjump.number.trigonometry import arctan

Array = NDArray[np.float64]


@compiled
def chord_angles(x: Any, y: Any) -> Any:
    """Directions (N - 2, between -pi and pi) of the chords between each inner node's neighbours."""
    inner = x.shape[0] - 2
    angles = np.empty(inner)
    for j in range(inner):
        dx = x[j + 2] - x[j]
        dy = y[j + 2] - y[j]
        angles[j] = 2.0 * arctan(dy / (sqrt(dx * dx + dy * dy) + dx))
    return angles


def chain_state(discretization: Any, x: Array, y: Array) -> Array:
    """States (..., D) of nodes at places x, y (..., N; in L) between flat clamps; nodes that turn
    lie along the chords of their neighbours."""
    dofs = discretization.node_dofs()
    state = np.zeros((*x.shape[:-1], dofs * x.shape[-1]))
    state[..., 0::dofs] = x
    state[..., 1::dofs] = y
    if dofs == 3:
        length = discretization.rotation_length()
        for k in np.ndindex(x.shape[:-1]):
            state[k][5:-3:3] = length * chord_angles(x[k], y[k])
    return state
