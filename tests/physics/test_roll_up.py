"""S3: a moment of 2 pi EI/L at its tip rolls a cantilever up to a circle."""

import numpy as np
import pytest
from scipy.optimize import brentq

from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.sim.cantilever import bend_cantilever

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
def test_discrete_formula(elements, reference):
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
