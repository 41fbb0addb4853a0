"""Views that own nothing."""

from typing import Any, NamedTuple

import numpy as np
from numba import njit, typeof

from snapjump.number.array import NumberArray, uncounted, uncounted_type


class Inner(NamedTuple):
    rows: Any
    factor: float


class Outer(NamedTuple):
    inner: Inner
    column: Any


@njit(cache=True)
def add_up(thing: Any) -> float:
    view = uncounted(thing)
    total = 0.0
    for i in range(view.inner.rows.shape[0]):
        for k in range(view.inner.rows.shape[1]):
            total += view.inner.factor * view.inner.rows[i, k] * view.column[i]
        view.column[i] = -1.0
    return total


def test_arrays_of_nested_tuples_are_seen_and_written_in_place() -> None:
    rows = np.arange(12.0).reshape(3, 4)
    table = np.arange(6.0).reshape(3, 2)
    expected = 2.0 * (rows.sum(axis=1) * table[:, 1]).sum()
    assert add_up(Outer(Inner(rows, 2.0), table[:, 1])) == expected
    assert table.tolist() == [[0.0, -1.0], [2.0, -1.0], [4.0, -1.0]]


def test_types_keep_their_class_and_layout() -> None:
    given = typeof(Outer(Inner(np.zeros((2, 2)), 1.0), np.zeros((3, 2))[:, 1]))
    viewed = uncounted_type(given)
    assert viewed.instance_class is Outer
    assert viewed.types[0].instance_class is Inner
    assert isinstance(viewed.types[1], NumberArray) and viewed.types[1].layout == "A"
    assert uncounted_type(viewed) is viewed
