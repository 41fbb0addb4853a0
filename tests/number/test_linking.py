"""Programs of many parts: all are linked, whoever calls them first; none is translated alone."""

import math

import numpy as np
import pytest
from numba import njit
from numba.core.runtime import _nrt_python, rtsys

from snapjump.number.dispatch import PROGRAM, kernel, routine
from snapjump.number.linking import Part, callers_first

program = njit(**{**PROGRAM, "cache": False})
NEVER = False


@routine
def cube(x):
    return x * x * x


@routine
def seldom(x):
    """Knows a part that it never calls: the branch is not compiled."""
    if NEVER:
        return cube(x)
    return 2.0 * x


@kernel
def often(x):
    return cube(x) + seldom(x)


@program
def total(x):
    return seldom(x) + often(x) + math.sqrt(cube(x))


def library_of(function):
    (compiled,) = function.overloads.values()
    return compiled.library


def test_parts_that_a_caller_only_names_are_linked_for_others():
    assert total(4.0) == 8.0 + 64.0 + 8.0 + 8.0
    names = [function.name for function in library_of(total).get_defined_functions()]
    assert any("total" in name for name in names)


def test_a_function_of_numba_s_own_may_call_parts():
    plain = njit(lambda x: often(x) + cube(x))
    assert plain(2.0) == 8.0 + 4.0 + 8.0
    parts = callers_first(library_of(plain))
    assert {part.name for part in parts} == {"often", "seldom", "cube"}
    for place, part in enumerate(parts):
        assert isinstance(part, Part) and part.get_pointer_to_function(part.name) == 0
        assert not set(part._linking_libraries) & set(parts[:place])


@routine
def pair(x):
    return np.full(3, x), (x, np.full(2, 2.0 * x))


@program
def sum_of_arrays(x):
    total = 0.0
    for _ in range(5):
        first, (factor, second) = pair(x)
        total += factor * first.sum() * second.sum()
    return total


@pytest.fixture
def counted():
    _nrt_python.memsys_enable_stats()
    yield
    _nrt_python.memsys_disable_stats()


def test_memory_that_parts_allocate_is_freed(counted):
    sum_of_arrays(2.0)
    before = rtsys.get_allocation_stats()
    assert sum_of_arrays(2.0) == 5 * 2.0 * 6.0 * 8.0
    after = rtsys.get_allocation_stats()
    assert after.alloc - before.alloc == after.free - before.free == 10
