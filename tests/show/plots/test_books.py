"""The balance line of energy.png."""

import copy

import numpy as np
import pytest

from snapjump.show.plots.ledger import read_ledger

from .conftest import of


def test_balance_of_kept_books_is_zero(jump):
    books = read_ledger(jump)
    assert books is not None
    assert books.unit_J == pytest.approx(2e11 * 1e-2 * 5e-5**3 / 12 / 0.02)
    assert np.abs(books.balance).max() < 1e-12
    assert books.total[-1] != pytest.approx(books.total[0])


@pytest.mark.parametrize(
    ("name", "sign"),
    [
        ("elastic_J", 1),
        ("kinetic_J", 1),
        ("gravitational_J", 1),
        ("contact_J", 1),
        ("clamp_work_J", -1),
        ("friction_loss_J", 1),
        ("damping_loss_J", 1),
        ("numerical_loss_J", 1),
    ],
)
def test_balance_shows_what_is_missing(jump, name, sign):
    wrong = copy.deepcopy(jump)
    unit = 2e11 * 1e-2 * 5e-5**3 / 12 / 0.02
    wrong.arrays[name][5:] += 0.1 * unit
    books = read_ledger(wrong)
    assert books is not None
    assert books.balance[:5] == pytest.approx(0.0, abs=1e-12)
    assert books.balance[5:] == pytest.approx(sign * 0.1)


def test_books_without_losses_still_balance(snap):
    arrays = {name: snap.arrays[name] for name in ("time_s", "elastic_J")}
    books = read_ledger(of(snap, arrays=arrays))
    assert books is not None
    assert books.balance == pytest.approx(books.total - books.total[0])
