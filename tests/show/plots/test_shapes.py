"""Numbered shapes of a beam."""

import numpy as np
from matplotlib.figure import Figure

from snapjump.show.plots.shapes import draw_shapes, tints


def test_shapes_are_numbered_at_their_middles_in_the_order_of_time():
    x = np.linspace(-0.4, 0.4, 9)
    axes = Figure().add_subplot()
    draw_shapes(axes, [(x, height * np.cos(4.0 * x)) for height in (0.2, 0.0, -0.2)])
    told = [(text.get_text(), *text.get_position()) for text in axes.texts]
    assert told == [("1", 0.0, 0.2), ("2", 0.0, 0.0), ("3", 0.0, -0.2)]
    assert len(axes.lines) == 3 + 2, "clamps at the first and at the last"
    assert len(set(tints(7))) == 7
