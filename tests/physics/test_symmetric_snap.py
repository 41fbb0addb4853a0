"""S5, S6, S10: where the symmetrically rotated arch loses stability, before and after."""

import numpy as np
import pytest
from differences import richardson
from physical import arch, snap
from references import outputs_of as reference
from scipy.optimize import brentq

# Extensibility lowers the angle by about 40 lambda/epsilon; the stiffer, the more rounding.
SLENDERNESS = {1e-3: 2.5e-5, 1e-2: 5e-5, 0.2: 2e-4, 0.3: 2e-4, 0.4: 2e-4}
QUICK = [1e-3, 0.1, 0.2, 0.3]
MORE = [1e-2, 0.03, 0.05, 0.4]
NAMES = (
    "alpha_asym", "E_before_asym", "E_after_asym", "dE_asym", "ymid_before_asym",
    "ymin_before_asym", "ymid_after_asym",
)  # fmt: skip


def figures(found) -> np.ndarray:
    before, after = found.before, found.after
    energies = (before.energy, after.energy, before.energy - after.energy)
    return np.array([found.alpha_rad, *energies, before.midpoint, -found.h1_bar, -found.h2_bar])


def family(epsilon: float, name: str = "der") -> list[np.ndarray]:
    """The figures at 40, 80 and 160 elements; Newton's method needs twice as many where shear is
    as stiff as here."""
    ratio = SLENDERNESS.get(epsilon, 1e-4 if name == "der" else 2e-4)
    sizes = (80, 160, 320) if name == "geometrically_exact" else (40, 80, 160)
    return [figures(snap(epsilon, n, ratio=ratio, name=name)) for n in sizes]


@pytest.mark.parametrize(
    "name, epsilon",
    [("der", e) for e in QUICK]
    + [pytest.param("der", e, marks=pytest.mark.slow) for e in MORE]
    + [(name, e) for name in ("corotational", "geometrically_exact") for e in QUICK[1:]],
)
def test_pitchfork(name, epsilon):
    entry = reference(f"S5_snap_sym_eps{epsilon:g}")
    exact = np.array([entry[name] for name in NAMES])
    coarse, middle, fine = family(epsilon, name)
    errors = np.abs([middle[0] - exact[0], fine[0] - exact[0]])
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)
    assert np.allclose(fine, exact, rtol=1e-3, atol=0.0)
    limit = richardson(coarse, middle, fine)
    assert np.allclose(limit, exact, rtol=1e-5, atol=0.0)


@pytest.mark.parametrize("epsilon", [0.1, 0.2])
def test_two_fixed_nodes_are_half_a_percent_off(epsilon):
    alpha = snap(epsilon, 160, clamp="two_nodes").alpha_rad
    assert alpha == pytest.approx(reference(f"S5_snap_sym_eps{epsilon:g}")["alpha_asym"], rel=5e-3)


def test_shallow_limits():
    shallow = reference("S6_shallow_limits")["energies_over_eps"]
    epsilon = 1e-3
    alpha, before, after, released, middle, _, below = richardson(*family(epsilon))
    names = [f"E_over_eps_{state}" for state in ("before", "after", "released")]
    energies = np.array([before, after, released]) / epsilon
    assert energies == pytest.approx([shallow[name] for name in names], rel=1e-3)
    names = ["mu_asym_bif", "wmid_before_asym", "wmid_after"]
    others = np.array([alpha, middle, below]) / np.sqrt(epsilon)
    assert others == pytest.approx([shallow[name] for name in names], rel=1e-3)


def test_shallow_arch_turned_at_one_end():
    """The right clamp stays flat where it lags by just the left clamp's critical angle."""
    epsilon = 1e-3

    def critical(elements: int) -> float:
        def excess(lag: float) -> float:
            return snap(epsilon, elements, lag, 2e-5).alpha_rad - lag

        return brentq(excess, 0.05, 0.06, xtol=1e-8)

    mu = richardson(*(critical(n) for n in (20, 40, 80))) / np.sqrt(epsilon)
    assert mu == pytest.approx(reference("S6_shallow_limits")["one_end"]["mu_fold"], rel=1e-3)


def test_shallow_arch_turned_against_itself():
    """Beyond a supercritical pitchfork only the S shape is left; its lowest eigenvalue grows
    linearly from zero there."""
    epsilon = 1e-3

    def critical(elements: int) -> float:
        beam = arch(epsilon, elements)
        state = beam.solve_equilibrium(beam.guess(), 0.0, 0.0)
        root = np.sqrt(epsilon)
        for mu in (0.5, 1.0, 1.5, 1.8, 1.9, 1.95, 1.98, 2.0, 2.02):
            state = beam.solve_equilibrium(state, mu * root, -mu * root)
        eigenvalues = []
        angles = (2.05, 2.1, 2.15)
        for mu in angles:
            state = beam.solve_equilibrium(state, mu * root, -mu * root)
            assert abs(beam.equilibrium(state, mu * root, -mu * root).midpoint) < 1e-9
            eigenvalues.append(beam.stability()[0])
        curve = np.polynomial.Polynomial.fit(angles, eigenvalues, 2)
        return brentq(curve, 1.9, 2.1)

    mu = richardson(*(critical(n) for n in (20, 40, 80)))
    assert mu == pytest.approx(reference("S6_shallow_limits")["antisym"]["mu_pitchfork"], rel=1e-3)


def test_released_programs_heights():
    """The released program fits h1 within 7 % and h2 within 1.5 %."""
    entry = reference("S10_authors_h1h2")
    found = [snap(epsilon, 160) for epsilon in (0.1, 0.2, 0.3)]
    h1, h2 = ([getattr(one, name) for one in found] for name in ("h1_bar", "h2_bar"))
    assert h1 == pytest.approx(entry["exact_minus_ymin"][:3], rel=1e-3)
    assert h2 == pytest.approx(entry["exact_minus_ymid_after"][:3], rel=1e-3)
    assert h1 == pytest.approx(entry["authors_h1"][:3], rel=0.07)
    assert h2 == pytest.approx(entry["authors_h2"][:3], rel=0.015)
