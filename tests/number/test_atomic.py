"""Counters that threads share: no number is handed out twice."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numba import njit

from snapjump.number.atomic import fetch_add


@njit(nogil=True)
def draw(counter, drawn):
    for k in range(drawn.shape[0]):
        drawn[k] = fetch_add(counter, 1, 3)


def test_every_number_is_drawn_once():
    counter = np.array([7, 0])
    drawn = np.zeros((4, 200_000), dtype=np.int64)
    draw(counter, drawn[0, :0])
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda row: draw(counter, row), drawn))
    assert counter.tolist() == [7, 3 * drawn.size]
    assert np.array_equal(np.sort(drawn.ravel()), 3 * np.arange(drawn.size))


def test_plain_python_counts_alike():
    counter = np.array([7, 0])
    assert [fetch_add(counter, 1, 3) for _ in range(4)] == [0, 3, 6, 9]
    assert counter.tolist() == [7, 12]
