"""The lowest point between nodes: exact where it is known, and smooth in the nodes' heights."""

import numpy as np
import pytest

from snapjump.statics.lowest_point import lowest_height


def test_a_quintic_is_its_own_spline():
    places = np.arange(9.0)
    heights = (places - 3.3) ** 2 * (1.0 + 0.02 * (places - 3.3) ** 3) - 0.7
    assert lowest_height(heights) == pytest.approx(-0.7, abs=1e-12)


def test_the_lowest_node_may_be_an_end():
    assert lowest_height(np.arange(8.0)) == 0.0
    assert lowest_height(-np.arange(8.0)) == -7.0


def test_it_is_smooth_as_the_lowest_point_passes_a_node():
    """A wave that is shifted past nodes keeps its depth."""
    places = np.arange(105.0)
    shifts = np.linspace(-2.0, 2.0, 201)
    found = [lowest_height(-0.08 * np.sin(6.0 * (places - shift) / 104.0)) for shift in shifts]
    assert np.ptp(found) < 1e-11
    assert found[100] == pytest.approx(-0.08, abs=1e-11)
