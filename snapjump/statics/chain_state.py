"""The nodes of a chain as a part of the state vector."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import node_dofs, turn_length

Array = NDArray[np.float64]


def chain_state(discretization: Any, x: Array, y: Array) -> Array:
    """State of nodes at places x, y (in L) between flat clamps; nodes that turn lie along the
    chords of their neighbours."""
    dofs = node_dofs(discretization)
    state = np.zeros(dofs * len(x))
    state[0::dofs] = x
    state[1::dofs] = y
    if dofs == 3:
        directions = np.unwrap(np.arctan2(y[2:] - y[:-2], x[2:] - x[:-2]))
        state[5:-3:3] = turn_length(discretization) * directions
    return state
