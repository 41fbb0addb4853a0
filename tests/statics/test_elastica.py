"""The exact arch against elliptic functions of a library."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipj, ellipk

from snapjump.statics.chain_state import chord_angles
from snapjump.statics.elastica import buckled_arch


@pytest.mark.parametrize("epsilon", [1e-4, 0.01, 0.2, 0.4])
def test_arch(epsilon):
    elements = 60
    m = brentq(lambda m: 2.0 - 2.0 * ellipe(m) / ellipk(m) - epsilon, 1e-12, 0.9, xtol=1e-16)
    s = (np.arange(elements) + 0.5) / elements
    tangent = 2.0 * np.arcsin(np.sqrt(m) * ellipj(4.0 * ellipk(m) * s, m)[0])
    x, y = buckled_arch(epsilon, elements)
    stretch = (1.0 - epsilon) / (np.cos(tangent).sum() / elements)
    assert np.allclose(np.diff(x), stretch * np.cos(tangent) / elements, rtol=0.0, atol=1e-13)
    assert np.allclose(np.diff(y), np.sin(tangent) / elements, rtol=0.0, atol=1e-13)
    assert x[0] == pytest.approx(-x[-1], abs=1e-15) and abs(y[-1]) < 1e-14


def test_many_arches_are_each_its_own():
    together = buckled_arch(np.array([0.1, 0.2]), 20)
    for k, epsilon in enumerate((0.1, 0.2)):
        for both, alone in zip(together, buckled_arch(epsilon, 20), strict=True):
            assert np.array_equal(both[k], alone)


@pytest.mark.parametrize("angle", np.linspace(-3.0, 3.0, 13))
def test_directions_of_chords(angle):
    x, y = np.array([0.0, 9.0, np.cos(angle)]), np.array([0.0, 9.0, np.sin(angle)])
    assert chord_angles(x, y)[0] == pytest.approx(angle, abs=1e-14)
