"""S8: convergence in the number of elements, half-element clamps against two fixed nodes."""

import numpy as np
import pytest

SIZES = (20, 40, 80, 160)
LETTERS = {"two_nodes": "A", "half_element": "B"}
NAMES = ("ymid0", "E0", "alpha_asym", "E_asym", "ymid_asym")


def figures(arch, snap, epsilon: float, elements: int, clamp: str) -> np.ndarray:
    beam = arch(epsilon, elements, clamp=clamp)
    flat = beam.equilibrium(beam.solve_equilibrium(beam.guess(), 0.0, 0.0), 0.0, 0.0)
    found = snap(epsilon, elements, clamp=clamp)
    before = found.before
    return np.array([flat.midpoint, flat.energy, found.alpha_rad, before.energy, before.midpoint])


@pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])
@pytest.mark.parametrize("epsilon", [0.1, 0.2])
def test_rows_and_orders(epsilon, clamp, arch, snap, reference):
    exact_alpha = reference(f"S5_snap_sym_eps{epsilon:g}")["alpha_asym"]
    exact_height = reference(f"S4_postbuckled_eps{epsilon:g}")["ymid"]
    rows = {
        row["n"]: row
        for row in reference("S8_DER_convergence")
        if row["eps"] == epsilon and row["clamp"] == LETTERS[clamp]
    }
    errors = []
    for elements in SIZES:
        found = figures(arch, snap, epsilon, elements, clamp)
        expected = np.array([rows[elements][name] for name in NAMES])
        assert np.allclose(found, expected, rtol=1e-6, atol=1e-6)
        errors.append([abs(found[0] - exact_height), abs(found[2] - exact_alpha)])
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))[-1]
    declared = 2.0 if clamp == "half_element" else 1.0
    assert np.allclose(orders, declared, atol=0.15)
