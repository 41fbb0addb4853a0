"""Band matrices against dense linear algebra."""

import numpy as np
import pytest
from plain_python import whole

from snapjump.statics.band import (
    WIDTH,
    factor,
    quadratic_form,
    smallest_eigenvalue,
    solve_bordered,
    substitute,
    subtract_product,
)

SIZE = 40


@pytest.fixture
def band() -> np.ndarray:
    """A random band, positive definite; what lies below its last row is nonsense."""
    values = np.random.default_rng(3).normal(size=(SIZE, WIDTH))
    values[:, 0] += 8.0
    return values


def test_solution(band):
    right = np.random.default_rng(4).normal(size=SIZE)
    factors, x = np.empty_like(band), right.copy()
    assert factor(band, 0.0, factors) == 0
    substitute(factors, x)
    assert np.allclose(x, np.linalg.solve(whole(band), right), rtol=1e-12)
    subtract_product(band, x, right)
    assert np.abs(right).max() < 1e-13


def test_signs_of_pivots_count_eigenvalues(band):
    eigenvalues = np.linalg.eigvalsh(whole(band))
    for count in (0, 1, 2, 7):
        shift = eigenvalues[count] - 1e-3
        assert factor(band, shift, np.empty_like(band)) == count


@pytest.mark.parametrize("moved", [0.0, -3.0, -30.0, 1e6])
def test_smallest_eigenvalue(band, moved):
    band[:, 0] += moved
    values, vectors = np.linalg.eigh(whole(band))
    vector = np.empty(SIZE)
    value, rounding, negative = smallest_eigenvalue(band, vector)
    assert value == pytest.approx(values[0], abs=1e-13 * max(1.0, abs(moved)))
    assert abs(vector @ vectors[:, 0]) == pytest.approx(1.0, abs=1e-12)
    assert negative == np.sum(values < 0.0)
    assert 0.0 < rounding < 1e-13 * max(1.0, abs(moved))


def test_rounding_of_a_form_is_that_of_its_entries(band):
    """Roundings of the matrix's entries move the form by about what is told."""
    random = np.random.default_rng(5)
    x = random.normal(size=SIZE)
    value, rounding = quadratic_form(band, x)
    assert value == pytest.approx(x @ whole(band) @ x, rel=1e-13)
    moved = [
        quadratic_form(band * (1.0 + 1e-8 * random.choice([-1.0, 1.0], band.shape)), x)[0]
        for _ in range(400)
    ]
    assert np.std(moved) * 2.0**-52 / 1e-8 == pytest.approx(rounding, rel=0.2)


@pytest.mark.parametrize("singular", [False, True])
def test_bordered_system(band, singular):
    """Regular at a fold, where the matrix alone is not."""
    random = np.random.default_rng(6)
    column, row, right = random.normal(size=(3, SIZE))
    if singular:
        band[:, 0] -= np.linalg.eigvalsh(whole(band))[0]
    bordered = np.block([[whole(band), column[:, None]], [row[None, :], np.array([[0.7]])]])
    expected = np.linalg.solve(bordered, np.append(right, 0.3))
    x, z = solve_bordered(band, column, row, 0.7, right, 0.3)
    assert np.allclose(np.append(x, z), expected, rtol=0.0, atol=1e-9 * np.abs(expected).max())
