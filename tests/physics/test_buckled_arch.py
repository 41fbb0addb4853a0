"""S4: the arch between flat clamps, against the exact elastica."""

import numpy as np
import pytest

# Extensibility changes a shallow arch by about 20 lambda/epsilon, the more the shallower it is.
SLENDERNESS = {1e-4: 5e-6, 1e-3: 2e-5, 1e-2: 5e-5}
EPSILONS = [1e-4, 1e-3, 1e-2, 0.03, 0.05, 0.1, 0.2, 0.3, 0.4]


def settled(arch, epsilon: float, elements: int, clamp: str = "half_element") -> np.ndarray:
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
def test_flat_clamps(epsilon, arch, reference, richardson):
    entry = reference(f"S4_postbuckled_eps{epsilon:g}")
    exact = np.array([entry["ymid"], entry["E"], entry["kappa_mid"]])
    coarse, middle, fine = (settled(arch, epsilon, n) for n in (80, 160, 320))
    assert middle[0] == pytest.approx(exact[0], rel=1e-4)
    assert np.allclose(richardson(coarse, middle, fine), exact, rtol=1e-6, atol=0.0)


@pytest.mark.parametrize("epsilon", [0.01, 0.1, 0.3])
def test_two_fixed_nodes(epsilon, arch, reference):
    height = settled(arch, epsilon, 160, "two_nodes")[0]
    assert height == pytest.approx(reference(f"S4_postbuckled_eps{epsilon:g}")["ymid"], rel=4e-3)
