"""The elastica by collocation, against folds and arches in closed form."""

import numpy as np
import pytest

from experiments.arches import exact
from experiments.benchmarks.surface import collocation
from experiments.benchmarks.surface.collocation import Clamps, flat, fold, point

EXACT = 3e-9  # rad; the numbers have ten digits


@pytest.mark.parametrize(("epsilon", "delta_alpha"), [(0.1, 0.1), (0.3, 0.19)])
def test_folds_with_a_mismatch(epsilon, delta_alpha):
    known = exact.mismatched(epsilon, delta_alpha, stretches=False)["aL"]
    assert fold(Clamps(epsilon, delta_alpha)).left == pytest.approx(known, abs=EXACT)


def test_a_beam_that_stretches_snaps_earlier():
    stretch = (0.05 / 20.0) ** 2 / 12.0
    known = exact.mismatched(0.1, 0.1, stretches=True)["aL"]
    assert fold(Clamps(0.1, 0.1, stretch)).left == pytest.approx(known, abs=EXACT)


def test_the_symmetric_fold_in_elliptic_integrals():
    assert fold(Clamps(0.01, 0.0)).left == pytest.approx(
        exact.symmetric(0.01)["alpha_fold"], abs=EXACT
    )


def test_the_mirror_image_of_a_mismatch():
    lags, leads = fold(Clamps(0.1, 0.2)), fold(Clamps(0.1, -0.2))
    assert leads.left + 0.2 == pytest.approx(lags.left, abs=EXACT)


def test_the_arch_between_flat_clamps(monkeypatch):
    monkeypatch.setattr(collocation, "COARSE", 1e-9)
    epsilon, thrust = 0.01, 39.67692654  # of the flat arch, by elliptic integrals
    arch = point(thrust, Clamps(epsilon, 0.0), flat(epsilon))
    assert arch.left == pytest.approx(0.0, abs=1e-7)
    assert arch.states[3].max() == pytest.approx(exact.flat(epsilon)["ymid"], abs=1e-6)


def test_the_linearised_equations():
    rng = np.random.default_rng(0)
    states, change = rng.normal(size=(2, 4, 5))
    force, push = rng.normal(size=(2, 2))
    stretch, small = 0.1, 1e-6
    ahead, behind = (
        collocation.slopes(states + s * change, force + s * push, stretch) for s in (small, -small)
    )
    varied = collocation.varied_slopes(states, force, change, push, stretch)
    assert varied == pytest.approx((ahead - behind) / (2.0 * small), abs=1e-8)


def test_no_fold_is_told(monkeypatch):
    monkeypatch.setattr(collocation, "MOST_STEPS", 5)
    with pytest.raises(ArithmeticError, match="no fold"):
        fold(Clamps(0.1, 0.1))
