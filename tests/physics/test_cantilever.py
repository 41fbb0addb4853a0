"""S1: the cantilever under a dead force across its tip, against elliptic integrals."""

import numpy as np
import pytest

from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.sim.cantilever import bend_cantilever

# EA L^2/EI of a beam as good as inextensible.
STIFF = 1e9
TURNING = {
    "corotational": lambda n: Corotational.Beam(1.0 / n, STIFF),
    "geometrically_exact": lambda n: GeometricallyExact.Beam(1.0 / n, STIFF, 0.32 * STIFF),
}
FIGURES = ("tip_angle", "delta_y", "one_minus_x", "E", "kappa_root")


def bent(load: float, elements: int) -> np.ndarray:
    """The reference's figures, of a chain of N elements."""
    length = 1.0 / elements
    rod = DiscreteElasticRod.Beam(length, STIFF, 0.5 * length, 0.0)
    nodes, energy, negative = bend_cantilever(rod, elements, 0.0, load, 0.0)
    assert negative == 0
    first, last = nodes[1] - nodes[0], nodes[-1] - nodes[-2]
    # The last edge's direction is that of the middle of the last element, where the moment is
    # P cos(theta) l/2 and falls to zero at the tip: theta_tip exceeds it by P cos(theta) l^2/8.
    tip = np.arctan2(last[1], last[0])
    tip += load * np.cos(tip) * length**2 / 8.0
    # The clamp's hinge carries the root's moment, kappa (1 + t^2).
    t = np.tan(0.5 * np.arctan2(first[1], first[0]))
    root = 2.0 * t * (1.0 + t * t) / (0.5 * length)
    return np.array([tip, nodes[-1, 1], 1.0 - nodes[-1, 0], energy, root])


@pytest.mark.parametrize("load", [0.1, 1.0, 5.0, 10.0])
def test_tip_load(load, reference, richardson):
    exact = np.array([reference(f"S1_cantilever_a{load:g}")[name] for name in FIGURES])
    coarse, middle, fine = (bent(load, n) for n in (40, 80, 160))
    assert np.allclose(middle, exact, rtol=1e-3, atol=0.0)
    # The half element at the free end adds a term in 1/N^3.
    limit = richardson(coarse, middle, fine, following=3)
    assert np.allclose(limit, exact, rtol=1e-6, atol=0.0)


@pytest.mark.parametrize("name", TURNING)
@pytest.mark.parametrize("load", [0.1, 1.0, 5.0, 10.0])
def test_elements_with_rotations(name, load, reference, richardson):
    entry = reference(f"S1_cantilever_a{load:g}")
    exact = np.array([entry["delta_y"], entry["one_minus_x"], entry["E"]])

    def figures(elements: int) -> np.ndarray:
        nodes, energy, negative = bend_cantilever(TURNING[name](elements), elements, 0.0, load, 0.0)
        assert negative == 0
        return np.array([nodes[-1, 1], 1.0 - nodes[-1, 0], energy])

    values = [figures(n) for n in (40, 80, 160)]
    changes = np.abs(np.diff(values, axis=0))
    assert np.allclose(values[1], exact, rtol=2e-4, atol=0.0)
    assert np.allclose(np.log2(changes[0] / changes[1]), 2.0, atol=0.15)
    assert np.allclose(richardson(*values), exact, rtol=1e-6, atol=0.0)
