"""S1, S3: cantilevers under a dead force across the tip, and rolled up to a circle by a moment."""

import numpy as np
import pytest
from differences import richardson
from references import outputs_of as reference
from scipy.optimize import brentq

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
def test_tip_load(load):
    exact = np.array([reference(f"S1_cantilever_a{load:g}")[name] for name in FIGURES])
    coarse, middle, fine = (bent(load, n) for n in (40, 80, 160))
    assert np.allclose(middle, exact, rtol=1e-3, atol=0.0)
    # The half element at the free end adds a term in 1/N^3.
    limit = richardson(coarse, middle, fine, following=3)
    assert np.allclose(limit, exact, rtol=1e-6, atol=0.0)


@pytest.mark.parametrize("name", TURNING)
@pytest.mark.parametrize("load", [0.1, 1.0, 5.0, 10.0])
def test_elements_with_rotations(name, load):
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


MOMENT = 2.0 * np.pi
# Pure bending stretches nothing, so that a soft beam does as well, with less rounding.
STRETCHING = 1e5


def rolled(elements: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes, and the directions of the edges without jumps of 2 pi."""
    length = 1.0 / elements
    rod = DiscreteElasticRod.Beam(length, STRETCHING, 0.5 * length, 0.0)
    nodes, _, _ = bend_cantilever(rod, elements, 0.0, 0.0, MOMENT)
    edges = np.diff(nodes, axis=0)
    return nodes, np.unwrap(np.arctan2(edges[:, 1], edges[:, 0]))


def turn_of_hinge(length: float) -> float:
    """Angle of a hinge from M = 2 t (1 + t^2) / length, t = tan(phi/2)."""
    t = brentq(lambda t: 2.0 * t * (1.0 + t * t) / length - MOMENT, 0.0, 10.0, xtol=1e-15)
    return 2.0 * np.arctan(t)


@pytest.mark.parametrize("elements", [20, 40, 80])
def test_discrete_formula(elements):
    _, directions = rolled(elements)
    turns = np.diff(directions)
    cells = elements * turns / (2.0 * np.pi)
    assert np.allclose(cells, reference("S3_rollup")[str(elements)], rtol=1e-9, atol=0.0)
    total = (elements - 1) * turn_of_hinge(1.0 / elements) + turn_of_hinge(0.5 / elements)
    assert directions[-1] == pytest.approx(total, rel=1e-9)


def test_second_order_towards_the_circle():
    gaps = [np.linalg.norm(rolled(n)[0][-1]) for n in (80, 160)]
    assert gaps[1] < 2e-3
    assert np.log2(gaps[0] / gaps[1]) == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize(
    "beam", [Corotational.Beam(0.05, STRETCHING), GeometricallyExact.Beam(0.05, STRETCHING, 3e4)]
)
def test_elements_with_rotations_close_at_once(beam):
    """Bending is constant, which both represent exactly: a regular polygon, whole turn and all."""
    nodes, energy, _ = bend_cantilever(beam, 20, 0.0, 0.0, MOMENT)
    assert np.linalg.norm(nodes[-1]) < 1e-12
    assert energy == pytest.approx(0.5 * MOMENT**2, rel=1e-12)
    edges = np.diff(nodes, axis=0)
    turns = np.diff(np.unwrap(np.arctan2(edges[:, 1], edges[:, 0])))
    assert np.allclose(turns, 2.0 * np.pi / 20, rtol=1e-10, atol=0.0)
    assert np.allclose(np.hypot(*edges.T), 0.05, rtol=1e-10, atol=0.0)
