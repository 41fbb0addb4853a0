"""Instants of a snap that is made up."""

from typing import Any

import numpy as np

from snapjump.scenes.swing import Swing, crossing, lowest, sinking


def test_instants_between_which_the_midpoint_sinks_by_equal_steps():
    time = np.linspace(0.0, 4.0, 401)
    height = np.cos(time)  # lowest at pi
    nodes = np.repeat(height[:, None], 3, axis=1)
    clamp: Any = None
    swing = Swing("ok", time, np.zeros_like(nodes), nodes, nodes, clamp, 1.0)
    k = crossing(swing)
    assert k is not None and abs(time[k] - 0.5 * np.pi) < 0.01
    chosen = sinking(swing, k, 5)
    assert (chosen[0], chosen[-1]) == (0, lowest(swing, k))
    assert np.abs(height[chosen] - [1.0, 0.5, 0.0, -0.5, -1.0]).max() < 0.01
