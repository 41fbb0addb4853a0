"""S2: critical loads of straight beams, where the tangent's smallest eigenvalue vanishes.

Along a straight beam stretching and bending decouple, so that the tangent's rows and columns of
y alone decide. The axial compliance is removed exactly: shortened elements of length
l (1 - P/EA) multiply the load by that factor. Pinned ends cannot be expressed: no frame leaves
a clamp free to turn, hence no pinned_pinned and clamped_pinned.
"""

from collections.abc import Callable

import bare_models
import numpy as np
import pytest
from physical import arch
from references import outputs_of as reference
from scipy.linalg import eig_banded
from scipy.optimize import brentq

from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.model import numbers_of
from snapjump.engine.work import make_memory, sizes_of

# Softer than a real beam, so that rounding of the elements' lengths does not spoil the load.
SOFT = 1e4
RATIO = np.sqrt(12.0 / SOFT)
SIZES = (10, 20, 40, 66, 80, 100, 160, 190)


def smallest(band: np.ndarray) -> float:
    """Smallest eigenvalue of the y coordinates' part of a lower band over x and y."""
    transverse = np.ascontiguousarray(band[1::2, ::2].T)
    values = eig_banded(transverse, lower=True, eigvals_only=True, select="i", select_range=(0, 0))
    return float(values[0])


def vanishing(eigenvalue: Callable[[float], float], low: float, high: float, loads: int) -> float:
    """The load at which the eigenvalue vanishes, without its share of axial compliance.

    The matrix's entries grow like 6 N^3 while the eigenvalue's slope falls like 1/N: a smooth
    curve through many loads averages their rounding out.
    """
    near = brentq(eigenvalue, low, high, xtol=1e-6)
    shares = 0.03 * np.cos(np.pi * (np.arange(loads) + 0.5) / loads)
    values = [eigenvalue(near * (1.0 + share)) for share in shares]
    curve = np.polynomial.Polynomial.fit(shares, values, 3)
    share = brentq(curve, -0.02, 0.02, xtol=1e-15)
    load = near * (1.0 + share)
    return load * (1.0 - load / SOFT)


def clamped(elements: int, clamp: str) -> float:
    """Critical load of the beam between two clamps."""
    held = 2 if clamp == "two_nodes" else 0
    chain = elements - held

    def eigenvalue(load: float) -> float:
        shortened = load / SOFT * chain / elements
        straight = arch(shortened, elements, RATIO, clamp)
        half = 0.5 * (1.0 - shortened) - straight.rod.clamp_offset
        state = np.zeros(straight.size)
        state[0::2] = np.linspace(-half, half, chain + 1)
        assert np.abs(straight.residual(state, 0.0, 0.0)).max() < 1e-8
        return smallest(straight.tangent_band())

    return vanishing(eigenvalue, 20.0, 60.0, 100)


def cantilever(elements: int) -> float:
    """Critical load of the beam with one clamp and a free end."""
    length = 1.0 / elements
    rod = DiscreteElasticRod.Beam(length, SOFT, 0.5 * length, 0.0)
    masses = np.zeros(elements + 1)
    memory = make_memory(sizes_of(bare_models.cantilever(rod), elements + 1))

    def eigenvalue(load: float) -> float:
        pushed = bare_models.cantilever(rod, -load)
        memory.state[:] = 0.0
        memory.state[0::2, 0] = np.linspace(0.0, 1.0 - load / SOFT, elements + 1)
        equilibrate(pushed, numbers_of(pushed), masses, memory, False)
        assert np.abs(memory.residual[2:, 0]).max() < 1e-8
        return smallest(memory.band[2:, :, 0])

    return vanishing(eigenvalue, 1.0, 4.0, 1600)


@pytest.mark.parametrize("elements", SIZES)
def test_discrete_closed_forms(elements):
    exact = reference("S2b_euler_discrete")[str(elements)]
    assert clamped(elements, "half_element") == pytest.approx(exact["cc_half_voronoi"], rel=1e-8)
    assert clamped(elements, "two_nodes") == pytest.approx(exact["cc_edge_clamp"], rel=1e-8)
    assert cantilever(elements) == pytest.approx(exact["cf_half_voronoi"], rel=1e-8)


def test_orders():
    """Half an element is second order, two fixed nodes are first order."""
    exact = reference("S2_euler_loads")
    for load, order, limit in (
        (lambda n: clamped(n, "half_element"), 2.0, exact["clamped_clamped"]),
        (lambda n: clamped(n, "two_nodes"), 1.0, exact["clamped_clamped"]),
        (cantilever, 2.0, exact["clamped_free"]),
    ):
        errors = [abs(load(n) - limit) for n in (80, 160)]
        assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.05)
