"""S4, S8: arches between flat clamps and at their snap, in the number of elements and by clamps."""

import numpy as np
import pytest
from differences import richardson
from physical import arch, snap
from references import outputs_of as reference

# Extensibility changes a shallow arch by about 20 lambda/epsilon, the more the shallower it is.
SLENDERNESS = {1e-4: 5e-6, 1e-3: 2e-5, 1e-2: 5e-5}
EPSILONS = [1e-4, 1e-3, 1e-2, 0.03, 0.05, 0.1, 0.2, 0.3, 0.4]


def settled(epsilon: float, elements: int, clamp: str = "half_element") -> np.ndarray:
    """Height of the middle, energy, curvature in the middle."""
    beam = arch(epsilon, elements, SLENDERNESS.get(epsilon, 1e-4), clamp)
    flat = beam.equilibrium(beam.solve_equilibrium(beam.guess(), 0.0, 0.0), 0.0, 0.0)
    assert flat.negative_pivots == 0
    middle = len(flat.x) // 2
    before, after = (
        np.array([flat.x[k + 1] - flat.x[k], flat.y[k + 1] - flat.y[k]])
        for k in (middle - 1, middle)
    )
    turn = np.arctan2(before[1], before[0]) - np.arctan2(after[1], after[0])
    return np.array([flat.midpoint, flat.energy, 2.0 * np.tan(0.5 * turn) * elements])


@pytest.mark.parametrize("epsilon", EPSILONS)
def test_flat_clamps(epsilon):
    entry = reference(f"S4_postbuckled_eps{epsilon:g}")
    exact = np.array([entry["ymid"], entry["E"], entry["kappa_mid"]])
    coarse, middle, fine = (settled(epsilon, n) for n in (80, 160, 320))
    assert middle[0] == pytest.approx(exact[0], rel=1e-4)
    assert np.allclose(richardson(coarse, middle, fine), exact, rtol=1e-6, atol=0.0)


@pytest.mark.parametrize("epsilon", [0.01, 0.1, 0.3])
def test_two_fixed_nodes(epsilon):
    height = settled(epsilon, 160, "two_nodes")[0]
    assert height == pytest.approx(reference(f"S4_postbuckled_eps{epsilon:g}")["ymid"], rel=4e-3)


SIZES = (20, 40, 80, 160)
LETTERS = {"two_nodes": "A", "half_element": "B"}
NAMES = ("ymid0", "E0", "alpha_asym", "E_asym", "ymid_asym")


def figures(epsilon: float, elements: int, clamp: str) -> np.ndarray:
    beam = arch(epsilon, elements, clamp=clamp)
    flat = beam.equilibrium(beam.solve_equilibrium(beam.guess(), 0.0, 0.0), 0.0, 0.0)
    found = snap(epsilon, elements, clamp=clamp)
    before = found.before
    return np.array([flat.midpoint, flat.energy, found.alpha_rad, before.energy, before.midpoint])


@pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])
@pytest.mark.parametrize("epsilon", [0.1, 0.2])
def test_rows_and_orders(epsilon, clamp):
    exact_alpha = reference(f"S5_snap_sym_eps{epsilon:g}")["alpha_asym"]
    exact_height = reference(f"S4_postbuckled_eps{epsilon:g}")["ymid"]
    rows = {
        row["n"]: row
        for row in reference("S8_DER_convergence")
        if row["eps"] == epsilon and row["clamp"] == LETTERS[clamp]
    }
    errors = []
    for elements in SIZES:
        found = figures(epsilon, elements, clamp)
        expected = np.array([rows[elements][name] for name in NAMES])
        assert np.allclose(found, expected, rtol=1e-6, atol=1e-6)
        errors.append([abs(found[0] - exact_height), abs(found[2] - exact_alpha)])
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))[-1]
    declared = 2.0 if clamp == "half_element" else 1.0
    assert np.allclose(orders, declared, atol=0.15)
