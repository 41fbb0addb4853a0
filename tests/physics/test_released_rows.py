"""Jumps at the released program's settings against its own data.

``released_rows.csv``: 60 of the 50,625 rows that the authors of arXiv 2408.10470 published with
their program (see experiments/data/README.md), every twenty-fifth of a sample of 1,500.
"""

from pathlib import Path

import numpy as np
import pytest

from experiments.compositions import composed
from experiments.released.data import differences, read_rows
from experiments.released.settings import released
from snapjump.batch import simulate_batch, variants

ROWS = Path(__file__).with_name("released_rows.csv")


@pytest.mark.compiles
def test_the_released_program_s_data_are_met():
    """Medians over 60 rows; measured 2 % in x and 0.6 % in y."""
    rows = read_rows(60, ROWS)
    assert len(rows.designs) == 60
    batch = simulate_batch(variants(composed(released()), rows.designs))
    assert set(batch.status) == {"ok"}
    x, y = differences(batch.x_bar, batch.y_bar, rows.x_bar, rows.y_bar)
    assert np.median(np.abs(x)) < 5.0
    assert np.median(np.abs(y)) < 2.0
    assert np.percentile(np.abs(x), 90) < 20.0
    assert np.percentile(np.abs(y), 90) < 6.0
