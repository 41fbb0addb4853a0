"""Functions of a number take arrays outside compiled code, and distinct rows are found."""

import numpy as np
import pytest

from snapjump.arrays import distinct_rows
from snapjump.number.functions import absolute, any_true, maximum, minimum, sqrt, where
from snapjump.number.trigonometry import arctan

VALUES = np.concatenate([np.linspace(-3.0, 3.0, 61), [0.0, -0.0, 0.4375, 1e-9, -1e9]])


@pytest.mark.parametrize(
    "function",
    [
        arctan,
        absolute,
        lambda x: sqrt(absolute(x)),
        lambda x: maximum(x, 0.5),
        lambda x: minimum(0.5, x),
        lambda x: where(x > 0.0, 2.0, x),
    ],
)
def test_an_array_is_read_to_the_bits_of_its_numbers(function):
    one_by_one = np.array([function(value) for value in VALUES.tolist()])
    assert function(VALUES).tobytes() == one_by_one.tobytes()


def test_a_mask_of_many_is_true_where_one_is():
    assert any_true(VALUES > 2.9) and not any_true(VALUES > 3.0)


def test_distinct_rows_of_a_table():
    rows = np.array([[2.0, 1.0], [0.0, 5.0], [2.0, 1.0], [0.0, 4.0], [2.0, np.nan]])
    different, places = distinct_rows(rows)
    assert len(different) == 4 and places[0] == places[2]
    assert different[places].tobytes() == rows.tobytes()
    assert [len(found) for found in distinct_rows(rows[:0])] == [0, 0]
