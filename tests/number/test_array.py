"""Views that own nothing."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from numba import njit, typeof
from numba.core.errors import NumbaError

from snapjump.number.array import NumberArray, uncounted, uncounted_type


class Inner(NamedTuple):
    rows: Any
    factor: float


class Outer(NamedTuple):
    inner: Inner
    column: Any


@njit
def add_up(thing: Any) -> float:
    view = uncounted(thing)
    total = 0.0
    for i in range(view.inner.rows.shape[0]):
        for k in range(view.inner.rows.shape[1]):
            total += view.inner.factor * view.inner.rows[i, k] * view.column[i]
        view.column[i] = -1.0
    return total


def test_arrays_of_nested_tuples_are_seen_and_written_in_place():
    rows = np.arange(12.0).reshape(3, 4)
    table = np.arange(6.0).reshape(3, 2)
    expected = 2.0 * (rows.sum(axis=1) * table[:, 1]).sum()
    assert add_up(Outer(Inner(rows, 2.0), table[:, 1])) == expected
    assert table.tolist() == [[0.0, -1.0], [2.0, -1.0], [4.0, -1.0]]


@njit(no_cpython_wrapper=True)
def copy(part: Any, other: Any) -> None:
    for k in range(part.shape[0]):
        other[k] = part[k]


@njit
def copy_parts(thing: Any, other: Any, row: int) -> None:
    rows = uncounted(thing).inner.rows
    rest, line = rows[1:], rows[row]
    for i in range(rest.shape[0]):
        other[0, i] = rest[i, 0]
    copy(line, other[1])
    copy(line[2:], other[2])
    copy(rows[:, 1], other[3])


def test_parts_are_views():
    for rows in (np.arange(12.0).reshape(3, 4), np.arange(24.0).reshape(3, 8)[:, ::2]):
        found = np.zeros((4, 4))
        copy_parts(Outer(Inner(rows, 2.0), rows[0]), found, 2)
        assert found[0, :2].tolist() == rows[1:, 0].tolist()
        assert found[1].tolist() == rows[2].tolist()
        assert found[2, :2].tolist() == rows[2, 2:].tolist()
        assert found[3, :3].tolist() == rows[:, 1].tolist()


@njit
def store_a_row(thing: Any) -> None:
    view = uncounted(thing)
    view[0] = view[1]


@njit
def every_other(thing: Any) -> Any:
    return uncounted(thing)[::2][0]


@pytest.mark.parametrize("unknown", [store_a_row, every_other])
def test_what_they_do_not_know_is_an_error(unknown):
    with pytest.raises((NotImplementedError, NumbaError)):
        unknown(np.zeros((2, 2)))


def test_types_keep_their_class_and_layout():
    given = typeof(Outer(Inner(np.zeros((2, 2)), 1.0), np.zeros((3, 2))[:, 1]))
    viewed = uncounted_type(given)
    assert viewed.instance_class is Outer
    assert viewed.types[0].instance_class is Inner
    assert isinstance(viewed.types[1], NumberArray) and viewed.types[1].layout == "A"
    assert uncounted_type(viewed) is viewed
